#include "common/contract/light_points.hpp"

#include "common/render/sampling.hpp"
#include "steps/step11_soft_shadows/soft_shadows.hpp"

namespace rt {

std::vector<Vec3> light_points(const Light& light, Vec3 from, std::uint32_t seed, int count) {
    std::vector<Vec3> points;
    for (int i = 0; i < count; ++i)
        points.push_back(sample_light(light, from, spread_sample(std::uint32_t(i), seed)));
    return points;
}

}  // namespace rt
