// origin: seen in student repositories
// caught by: the closest of several spheres is seen, in any order of the file (M1, "plusieurs objets")
// sentence: You compare the distances of the centers. The hit with the smallest t counts: a large sphere may be farther away by its center.
#include "common/math/vector.hpp"
#include "common/render/stage.hpp"

#include "steps/step03_sphere/sphere.hpp"

namespace rt {

Color trace(const Scene& scene, const Ray& ray, Context& context) {
    ++context.rays;
    const Primitive<Sphere>* closest = nullptr;
    Real smallest = infinity;
    Real t_of_closest = 0;
    for (const Primitive<Sphere>& each : scene.spheres) {
        const std::optional<Real> t = intersect(ray, each.shape, {});
        const Real away = length(each.shape.center - ray.origin);
        if (!t || away >= smallest) continue;
        closest = &each;
        smallest = away;
        t_of_closest = *t;
    }
    if (closest == nullptr) return background(scene, ray);
    const Vec3 point = at(ray, t_of_closest);
    const Vec3 outward = normal(closest->shape, point);
    if (context.settings.shading == Shading::normal) return color_from_normal(outward);
    return closest->material.color * torch(point, face_forward(outward, ray.direction), ray.origin);
}

}  // namespace rt
