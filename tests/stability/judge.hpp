// The comparison of an answer with the exact one, in the three measures of
// docs/reference/stability.md: in units of u L, L being the largest coordinate of the ray's origin,
// of the shape, and of the reported hit.
#pragma once

#include "tests/stability/sweeps.hpp"

#include "common/explain/text.hpp"

#include <optional>

namespace rt {

/// "Sphere".
template <class Shape>
[[nodiscard]] std::string kind_of() {
    const std::string text = code(Shape{});
    return text.substr(0, text.find('{'));
}

/// An answer against the exact one.
struct Judgment {
    bool wrong = false;          ///< hit or miss, or another root than the first
    std::optional<double> off;   ///< of a hit: the distance of o + t d from the surface, in u L
    std::optional<double> ulps;  ///< of a right hit: the distance of t from the exact one
};

// Each template is instantiated for the seven shapes of the exercises.

/// u L.
template <class Shape>
[[nodiscard]] double unit_of(const Case<Shape>& asked, std::optional<Real> got);

/// The distance of the hit from the surface, in u L. One that is certainly less than `known` is not
/// examined further, and gives 0.
template <class Shape>
[[nodiscard]] double off(const Case<Shape>& asked, Real got, double known);

template <class Shape>
[[nodiscard]] Judgment judged(const Case<Shape>& asked, std::optional<Real> got);

/// Returns whether the ray starts within 16 u L of the surface: then the start of the interval is
/// as near to a hit as its rounding.
template <class Shape>
[[nodiscard]] bool starts_on(const Case<Shape>& asked);

/// The backward error: the largest move of the ray, in u L, that makes a wrong answer right. An
/// answer that a move by `known` makes right is not examined further, and gives `known`.
template <class Shape>
[[nodiscard]] double band(const Case<Shape>& asked, std::optional<Real> got, double known);

/// The exact t, rounded once.
template <class Shape>
[[nodiscard]] std::optional<Real> exact_answer(const Case<Shape>& asked);

}  // namespace rt
