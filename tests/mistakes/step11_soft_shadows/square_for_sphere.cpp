// origin: the answer to the first part of the stage
// caught by: a light far away is sampled evenly over its disc (CR §3.3)
// sentence: Right so far: these are the points of CR's cube, put at the center of the light. The next part is the disc: the corners of the square are outside of the light.
#include "common/math/vector.hpp"

#include "steps/step02_camera_basis/camera_basis.hpp"
#include "steps/step11_soft_shadows/soft_shadows.hpp"

#define sample_light(...) correct_light_point(__VA_ARGS__)
#include "steps/step11_soft_shadows/reference/soft_shadows.cpp"
#undef sample_light

namespace rt {

Vec3 sample_light(const Light& light, Vec3 from, Vec2 sample) {
    const Vec3 away = from - light.position;
    if (!(length(away) > light.radius) || !(light.radius > 0)) return light.position;
    const Basis axes = orthonormal_basis(unit(away));
    return light.position +
           light.radius * ((2 * sample.x - 1) * axes.x + (2 * sample.y - 1) * axes.y);
}

}  // namespace rt
