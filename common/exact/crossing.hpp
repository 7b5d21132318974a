// What a shape is along a ray: where it is a polynomial's root, on the part of it where others are
// not negative. In what numbers is left open.
#pragma once

#include "common/ray.hpp"
#include "common/vector.hpp"

#include <array>

namespace rt::inline RT_PRECISION {

/// c0 + c1 t + c2 t².
template <class T>
struct Polynomial {
    T c0 = Real(0);
    T c1 = Real(0);
    T c2 = Real(0);
};

/// What a shape is along a ray.
template <class T, std::size_t count>
struct Crossing {
    T a = Real(0);  ///< a t² + 2 b t + c = 0 where the ray meets the whole of the surface
    T b = Real(0);
    T c = Real(0);
    std::array<Polynomial<T>, count> conditions;  ///< none of them negative on the shape's part
};

template <class T>
struct Triple {
    T x;
    T y;
    T z;

    friend Triple operator-(const Triple& v, const Triple& w) {
        return {v.x - w.x, v.y - w.y, v.z - w.z};
    }
};

/// How a shape says what it is along a ray: in units of this length, and of the ray's speed,
/// crossing_in(T(), ray) is a Crossing<T, …>.
template <class CrossingIn>
struct Along {
    Real length_unit;
    CrossingIn crossing_in;
};
template <class CrossingIn>
Along(Real, CrossingIn) -> Along<CrossingIn>;

}  // namespace rt::inline RT_PRECISION

namespace rt {

template <class T>
[[nodiscard]] T dot(const Triple<T>& v, const Triple<T>& w) {
    return v.x * w.x + v.y * w.y + v.z * w.z;
}

template <class T>
[[nodiscard]] Triple<T> cross(const Triple<T>& v, const Triple<T>& w) {
    return {v.y * w.z - v.z * w.y, v.z * w.x - v.x * w.z, v.x * w.y - v.y * w.x};
}

template <class T>
[[nodiscard]] Triple<T> exactly(Vec3 v) {
    return {T(v.x), T(v.y), T(v.z)};
}

}  // namespace rt
