// The engines that are compared.
#pragma once

#include "tests/measurements/workload.hpp"

#include <memory>

namespace measurements {

/// Raysteps in both precisions.
[[nodiscard]] std::unique_ptr<Engine> float_engine();
[[nodiscard]] std::unique_ptr<Engine> double_engine();

/// Embree 3, one ray at a time, with its defaults; null if CMake did not find it.
[[nodiscard]] std::unique_ptr<Engine> embree_engine();

}  // namespace measurements
