// origin: invented
// caught by: an interpolated normal never sends the ray below the flat face (CR §6)
// sentence: You compare ⟨R, side⟩ with a constant below 0: a ray that goes only a little into the face still meets what is behind it. Test ⟨R, side⟩ > 0.
#define mirrored(...) correct_mirrored(__VA_ARGS__)
#include "steps/step12_mirror/reference/mirror.cpp"
#undef mirrored

namespace rt {

Ray mirrored(const Ray& ray, const ShadingPoint& surface) {
    Ray reflected = correct_mirrored(ray, surface);
    const Vec3 side = surface.geometric_normal;
    const Vec3 d = ray.direction;
    reflected.direction = d - 2 * dot(d, surface.normal) * surface.normal;
    if (dot(reflected.direction, side) < Real(-1e-3) * length(d))
        reflected.direction = d - 2 * dot(d, side) * side;
    return reflected;
}

}  // namespace rt
