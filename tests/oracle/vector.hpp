// Three numbers of either kind.
#pragma once

#include "tests/oracle/exact.hpp"

namespace rt::oracle {

template <class T>
struct Vector {
    T x{0};
    T y{0};
    T z{0};

    friend Vector operator+(const Vector& a, const Vector& b) {
        return {a.x + b.x, a.y + b.y, a.z + b.z};
    }
    friend Vector operator-(const Vector& a, const Vector& b) {
        return {a.x - b.x, a.y - b.y, a.z - b.z};
    }
    friend Vector operator*(const T& s, const Vector& v) { return {s * v.x, s * v.y, s * v.z}; }
    Vector operator-() const { return {-x, -y, -z}; }
};

using ExactVector = Vector<Exact>;
using NumberVector = Vector<Number>;

template <class T>
T dot(const Vector<T>& a, const Vector<T>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class T>
Vector<T> cross(const Vector<T>& a, const Vector<T>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

[[nodiscard]] inline bool is_zero(const ExactVector& v) {
    return v.x.sign() == 0 && v.y.sign() == 0 && v.z.sign() == 0;
}

[[nodiscard]] inline NumberVector number(const ExactVector& v) {
    return {v.x.number(), v.y.number(), v.z.number()};
}

[[nodiscard]] inline Number length(const ExactVector& v) {
    return sqrt(dot(v, v).number());
}

/// v, which is not zero, normalized.
[[nodiscard]] inline NumberVector unit(const ExactVector& v) {
    return Number(1 / length(v)) * number(v);
}

}  // namespace rt::oracle
