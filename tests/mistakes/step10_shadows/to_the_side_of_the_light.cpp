// origin: invented
// caught by: the offset is along the flat face, wherever an interpolated normal points (CR §6)
// sentence: You start on the side of the light. If the light is behind the face, that is inside the shape, which then throws no shadow on its own back. Move along surface.geometric_normal as it is.
#define shadow_ray(...) correct_shadow_ray(__VA_ARGS__)
#include "steps/step10_shadows/reference/shadows.cpp"
#undef shadow_ray

namespace rt {

ShadowRay shadow_ray(const ShadingPoint& surface, Vec3 light) {
    ShadingPoint turned = surface;
    if (dot(light - surface.point, surface.geometric_normal) < 0)
        turned.geometric_normal = -surface.geometric_normal;
    return correct_shadow_ray(turned, light);
}

}  // namespace rt
