// A shape restricted to a ray: the roots in t of one quadratic at which some other polynomials are
// not negative. A template over the number type.
#pragma once

#include "common/geometry/ray.hpp"
#include "common/math/vector.hpp"

#include <array>

namespace rt {
inline namespace RT_PRECISION {

/// c0 + c1 t + c2 t².
template <class T>
struct Polynomial {
    T c0 = Real(0);
    T c1 = Real(0);
    T c2 = Real(0);
};

/// The intersection of a shape with a ray's line.
template <class T, std::size_t count>
struct Crossing {
    T a = Real(0);  ///< a t² + 2 b t + c = 0 at the intersections with the shape's whole surface
    T b = Real(0);
    T c = Real(0);
    std::array<Polynomial<T>, count>
        conditions;  ///< none is negative on the part that belongs to the shape
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

/// A shape and a ray for evaluation in several number types: in units of `length_unit` and of the
/// ray's speed, crossing_in(T(), ray) returns a Crossing<T, …>.
template <class CrossingIn>
struct Along {
    Real length_unit;
    CrossingIn crossing_in;
};
template <class CrossingIn>
Along(Real, CrossingIn) -> Along<CrossingIn>;

}  // namespace RT_PRECISION
}  // namespace rt

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
