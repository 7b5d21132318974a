// origin: invented: an array of 100 objects, as in C
// caught by: the closest of several spheres is seen, in any order of the file (M1, "plusieurs objets")
// sentence: You test a fixed number of spheres of the list. A scene may have any number.
#include "common/math/vector.hpp"
#include "common/render/stage.hpp"

#include "steps/step03_sphere/sphere.hpp"

namespace rt {

Color trace(const Scene& scene, const Ray& ray, Context& context) {
    ++context.rays;
    const Primitive<Sphere>* closest = nullptr;
    Real smallest = infinity;
    for (std::size_t i = 0; i < scene.spheres.size() && i < 100; ++i) {
        const Primitive<Sphere>& each = scene.spheres[i];
        const std::optional<Real> t = intersect(ray, each.shape, {});
        if (!t || *t >= smallest) continue;
        closest = &each;
        smallest = *t;
    }
    if (closest == nullptr) return background(scene, ray);
    const Vec3 point = at(ray, smallest);
    const Vec3 outward = normal(closest->shape, point);
    if (context.settings.shading == Shading::normal) return color_from_normal(outward);
    return closest->material.color * torch(point, face_forward(outward, ray.direction), ray.origin);
}

}  // namespace rt
