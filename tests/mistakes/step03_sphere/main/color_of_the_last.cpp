// origin: invented: t and sphere are not kept together
// caught by: the closest of several spheres is seen, in any order of the file (M1, "plusieurs objets")
// sentence: You keep the smallest t, but the last sphere that is hit. Keep the sphere together with its t.
#include "common/math/vector.hpp"
#include "common/render/stage.hpp"

#include "steps/step03_sphere/sphere.hpp"

namespace rt {

Color trace(const Scene& scene, const Ray& ray, Context& context) {
    ++context.rays;
    const Primitive<Sphere>* closest = nullptr;
    Real smallest = infinity;
    for (const Primitive<Sphere>& each : scene.spheres) {
        const std::optional<Real> t = intersect(ray, each.shape, {});
        if (!t) continue;
        closest = &each;
        smallest = std::min(smallest, *t);
    }
    if (closest == nullptr) return background(scene, ray);
    const Vec3 point = at(ray, smallest);
    const Vec3 outward = normal(closest->shape, point);
    if (context.settings.shading == Shading::normal) return color_from_normal(outward);
    return closest->material.color * torch(point, face_forward(outward, ray.direction), ray.origin);
}

}  // namespace rt
