// The references of three shapes, compiled with other options than the project's.
#pragma once

#include "tests/stability/sweeps.hpp"

#include <optional>
#include <vector>

namespace rt {

// The answers to all cases, one after the other.

[[nodiscard]] std::vector<std::optional<Real>> answers(const std::vector<Case<Sphere>>& cases);
[[nodiscard]] std::vector<std::optional<Real>> answers(const std::vector<Case<Plane>>& cases);
[[nodiscard]] std::vector<std::optional<Real>> answers(const std::vector<Case<Triangle>>& cases);

}  // namespace rt
