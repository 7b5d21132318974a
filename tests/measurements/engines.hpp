// The engines that are compared.
#pragma once

#include "tests/measurements/workload.hpp"

#include <memory>

namespace measurements {

/// Ours in both precisions.
[[nodiscard]] std::unique_ptr<Engine> float_engine();
[[nodiscard]] std::unique_ptr<Engine> double_engine();

/// Embree 3, one ray at a time, as it is by default; null if it was not found when CMake looked.
[[nodiscard]] std::unique_ptr<Engine> embree_engine();

}  // namespace measurements
