// Stage 11's points of a light, many at once.
#pragma once

#include "common/scene.hpp"

#include <cstdint>
#include <vector>

namespace rt {

/// What light_point gives for the first so many of the samples that are spread evenly from the
/// seed. Where a suite asks another process (tests/contract), that is one question.
[[nodiscard]] std::vector<Vec3> light_points(const Light& light, Vec3 from, std::uint32_t seed,
                                             int count);

}  // namespace rt
