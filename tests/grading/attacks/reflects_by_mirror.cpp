// attack: has stage 12 reflect for stage 9
// ceiling: as a stub
// stage: step09_phong
// compiles: no
// message: Your file calls rt::mirrored(
#include "steps/step09_phong/phong.hpp"

#include "common/geometry/ray.hpp"

namespace rt {

Ray mirrored(const Ray& ray, const ShadingPoint& surface);

Vec3 reflected(Vec3 to_light, Vec3 normal) {
    const ShadingPoint surface{.point = Vec3(0), .normal = normal, .geometric_normal = normal};
    return mirrored({.origin = to_light, .direction = -to_light}, surface).direction;
}

Color ambient_term(const ShadingPoint&, const Ambient&) {
    return Color(0);
}

Color diffuse_term(const ShadingPoint&, const Light&) {
    return Color(0);
}

Color specular_term(const ShadingPoint&, const Light&) {
    return Color(0);
}

}  // namespace rt
