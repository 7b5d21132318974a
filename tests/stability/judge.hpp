// The comparison of an answer with the exact one, in the three measures of
// docs/reference/stability.md: in units of u L, L being the largest coordinate of the ray's origin,
// of the shape, and of the reported hit.
#pragma once

#include "tests/stability/sweeps.hpp"

#include <optional>

namespace rt {

/// An answer against the exact one.
struct Judgement {
    bool wrong = false;          ///< hit or miss, or another root than the first
    std::optional<double> off;   ///< of a hit: the distance of o + t d from the surface, in u L
    std::optional<double> ulps;  ///< of a right hit: the distance of t from the exact one
};

[[nodiscard]] Judgement judged(const Case<Sphere>& asked, std::optional<Real> got);
[[nodiscard]] Judgement judged(const Case<Plane>& asked, std::optional<Real> got);
[[nodiscard]] Judgement judged(const Case<Triangle>& asked, std::optional<Real> got);
[[nodiscard]] Judgement judged(const Case<Square>& asked, std::optional<Real> got);
[[nodiscard]] Judgement judged(const Case<Cylinder>& asked, std::optional<Real> got);
[[nodiscard]] Judgement judged(const Case<Cone>& asked, std::optional<Real> got);

// The backward error: the largest move of the ray, in u L, that makes a wrong answer right. An
// answer that a move by `known` makes right is not examined further, and gives `known`.

[[nodiscard]] double band(const Case<Sphere>& asked, std::optional<Real> got, double known);
[[nodiscard]] double band(const Case<Plane>& asked, std::optional<Real> got, double known);
[[nodiscard]] double band(const Case<Triangle>& asked, std::optional<Real> got, double known);
[[nodiscard]] double band(const Case<Square>& asked, std::optional<Real> got, double known);
[[nodiscard]] double band(const Case<Cylinder>& asked, std::optional<Real> got, double known);
[[nodiscard]] double band(const Case<Cone>& asked, std::optional<Real> got, double known);

// The exact t, rounded once.

[[nodiscard]] std::optional<Real> exact_answer(const Case<Sphere>& asked);
[[nodiscard]] std::optional<Real> exact_answer(const Case<Plane>& asked);
[[nodiscard]] std::optional<Real> exact_answer(const Case<Triangle>& asked);
[[nodiscard]] std::optional<Real> exact_answer(const Case<Square>& asked);
[[nodiscard]] std::optional<Real> exact_answer(const Case<Cylinder>& asked);
[[nodiscard]] std::optional<Real> exact_answer(const Case<Cone>& asked);

}  // namespace rt
