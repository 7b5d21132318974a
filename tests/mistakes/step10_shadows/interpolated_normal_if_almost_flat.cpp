// origin: invented: the flat face only where the normals differ much
// caught by: the offset is along the flat face, wherever an interpolated normal points (CR §6)
// sentence: You start along the interpolated normal where it differs little from that of the flat face: the ray then starts less than surface.error above the face. The offset is always along surface.geometric_normal.
#define shadow_ray(...) correct_shadow_ray(__VA_ARGS__)
#include "steps/step10_shadows/reference/shadows.cpp"
#undef shadow_ray

namespace rt {

ShadowRay shadow_ray(const ShadingPoint& surface, Vec3 light) {
    ShadingPoint other = surface;
    if (dot(surface.normal, surface.geometric_normal) > Real(0.9))
        other.geometric_normal = surface.normal;
    return correct_shadow_ray(other, light);
}

}  // namespace rt
