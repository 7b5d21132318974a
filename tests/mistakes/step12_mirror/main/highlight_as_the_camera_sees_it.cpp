// origin: invented: V leads to the camera after reflections too
// caught by: a mirror shows what another mirror shows (CR §5.1)
// sentence: In the mirror your highlights are where the camera would see them. V leads back along the reflected ray: unit(-ray.direction), as shading_point has it.
#include "common/render/closest_hit.hpp"

namespace rt {

static ShadingPoint as_the_camera_sees_it(ShadingPoint surface, const Scene& scene) {
    surface.to_eye = unit(scene.cameras.front().position - surface.point);
    return surface;
}

}  // namespace rt

#define shading_point(hit, ray) as_the_camera_sees_it(shading_point(hit, ray), scene)
#include "tests/alternatives/step12_mirror/main/own_samples.cpp"
