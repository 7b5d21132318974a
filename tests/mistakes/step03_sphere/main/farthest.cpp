// origin: invented: the comparison reversed
// caught by: the closest of several spheres is seen, in any order of the file (M1, "plusieurs objets")
// sentence: You keep the farthest hit: the comparison of t is reversed.
#include "common/math/vector.hpp"
#include "common/render/stage.hpp"

#include "steps/step03_sphere/sphere.hpp"

namespace rt {

Color trace(const Scene& scene, const Ray& ray, Context& context) {
    ++context.rays;
    const Primitive<Sphere>* closest = nullptr;
    Real largest = 0;
    for (const Primitive<Sphere>& each : scene.spheres) {
        const std::optional<Real> t = intersect(ray, each.shape, {});
        if (!t || *t <= largest) continue;
        closest = &each;
        largest = *t;
    }
    if (closest == nullptr) return background(scene, ray);
    const Vec3 point = at(ray, largest);
    const Vec3 outward = normal(closest->shape, point);
    if (context.settings.shading == Shading::normal) return color_from_normal(outward);
    return closest->material.color * torch(point, face_forward(outward, ray.direction), ray.origin);
}

}  // namespace rt
