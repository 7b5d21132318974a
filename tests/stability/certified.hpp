// A certified kernel's answer against the exact one.
#pragma once

#include "tests/oracle/inputs.hpp"
#include "tests/stability/sweeps.hpp"

#include "steps/step03_sphere/sphere.hpp"
#include "steps/step04_plane/plane.hpp"
#include "steps/step05_triangle/triangle.hpp"
#include "steps/step06_square/square.hpp"
#include "steps/step07_cylinder/cylinder.hpp"
#include "steps/step08_cone/cone.hpp"

#include <cmath>
#include <cstdlib>
#include <string>

namespace rt {

/// The largest distance from the exact t, in ulps, found by a search that maximizes the error
/// (exact_climb_test.cpp); the proved bounds of the kernels are larger
/// (docs/reference/stability.md).
inline constexpr double certified_ulps = 11;

inline std::uint64_t number_from(const char* variable, std::uint64_t otherwise) {
    const char* said = std::getenv(variable);
    return said == nullptr ? otherwise : std::strtoull(said, nullptr, 10);
}

/// The distance from the exact t in ulps.
inline double ulps_between(Real got, const oracle::Number& expected) {
    const auto nearest = expected.convert_to<Real>();
    const Real ulp = std::nextafter(std::abs(nearest), infinity) - std::abs(nearest);
    return abs((oracle::Number(got) - expected) / oracle::Number(ulp)).convert_to<double>();
}

template <class Shape>
std::optional<oracle::Number> exact_t(const Case<Shape>& asked, Interval interval) {
    const auto root = intersect(exact(asked.ray), exact(asked.shape), exact(interval));
    if (!root) return std::nullopt;
    return root->value();
}

/// The distance of the answer from the exact one: infinite if one of them is a miss.
template <class Shape>
double ulps_off(const Case<Shape>& asked, Interval interval, std::optional<Real> got) {
    const auto expected = exact_t(asked, interval);
    if (got.has_value() != expected.has_value()) return double(infinity);
    return got ? ulps_between(*got, *expected) : 0;
}

}  // namespace rt
