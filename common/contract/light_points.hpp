// Stage 11's points of a light, many at once.
#pragma once

#include "common/scene/scene.hpp"

#include <cstdint>
#include <vector>

namespace rt {

/// The results of sample_light for the first `count` samples, well spread from the seed. If the
/// suite uses another process (common/contract), this is one query.
[[nodiscard]] std::vector<Vec3> light_points(const Light& light, Vec3 from, std::uint32_t seed,
                                             int count);

}  // namespace rt
