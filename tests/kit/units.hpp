// The same questions in other units: no answer depends on them, and a constant other than 0, such
// as an epsilon, is wrong in some of them.
#pragma once

#include "tests/kit/shape_checks.hpp"

namespace rt {

/// Everything is 2^size times as large, and directions are 2^length times as long.
struct Units {
    int size = 0;
    int length = 0;
};

// As far as each precision can represent the quantities of the documents' formulas: squares of
// directions, and products of up to four lengths.
constexpr bool is_float = sizeof(Real) == sizeof(float);
/// t is below 1e-12 in float, and below 1e-29 in double. The square of a direction in radii is
/// finite.
constexpr Units tiny_t = is_float ? Units{-12, 44} : Units{-48, 100};
/// Sizes and distances are about 1e7 in float, and 1e30 in double.
constexpr Units huge_shape = is_float ? Units{.size = 24} : Units{.size = 100};
/// Sizes and distances are about 1e-6 in float, and 1e-14 in double.
constexpr Units tiny_shape = is_float ? Units{.size = -22} : Units{.size = -48};
/// ‖d‖² is below 1e-27 in float, and below 1e-57 in double.
constexpr Units short_direction = is_float ? Units{.length = -50} : Units{.length = -100};

/// A vector's length, so far from 1 that products of four such lengths are just in range.
inline Real draw_length(Random& random) {
    constexpr int most = is_float ? 25 : 100;
    return std::ldexp(Real(1), random.below(2 * most + 1) - most);
}

/// A ray and a shape that it misses.
template <class Shape>
struct Past {
    Ray ray;
    Shape shape;
};

template <class Shape>
Past<Shape> in_units(const Ray& ray, const Shape& shape, Units units) {
    const Transform transform{.scale = std::ldexp(Real(1), units.size)};
    Ray scaled = transformed(ray, transform);
    scaled.direction *= std::ldexp(Real(1), units.length);
    return {.ray = scaled, .shape = transformed(shape, transform)};
}

// `draw` makes a Sample<Shape> from a Random, as in shape_checks.hpp; `draw_past` a Past<Shape>.

/// A hit is the same hit in any units, strictly inside the same interval.
template <class Draw>
Verdict hits_in(Units units, Draw draw) {
    return for_all([units, draw](Random& random) {
        const auto aimed = aimed_from_outside(draw(random), random);
        const auto [ray, shape] = in_units(aimed.ray, aimed.shape, units);
        const Real t = std::ldexp(aimed.t, -units.length);
        if (const Verdict hit = hits(ray, shape, t); !hit) return hit;
        const Interval around{.min = t * Real(0.99), .max = t * Real(1.01)};
        const Interval before{.min = 0, .max = t * Real(0.99)};
        if (const Verdict kept = hits(ray, shape, t, around); !kept) return kept;
        return misses(ray, shape, before);
    });
}

/// A miss is a miss in any units.
template <class Draw>
Verdict misses_in(Units units, Draw draw_past) {
    return for_all([units, draw_past](Random& random) {
        const auto past = draw_past(random);
        const auto [ray, shape] = in_units(past.ray, past.shape, units);
        return misses(ray, shape);
    });
}

}  // namespace rt
