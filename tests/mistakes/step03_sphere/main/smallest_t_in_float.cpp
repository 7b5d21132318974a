// origin: invented: float in place of Real
// caught by: the closest of several spheres is seen, in any order of the file (M1, "plusieurs objets")
// sentence: You keep the smallest t in a float: of two spheres that almost coincide, you show the wrong one. Its type is Real.
#include "common/math/vector.hpp"
#include "common/render/stage.hpp"

#include "steps/step03_sphere/sphere.hpp"

namespace rt {

Color trace(const Scene& scene, const Ray& ray, Context& context) {
    ++context.rays;
    const Primitive<Sphere>* closest = nullptr;
    float smallest = std::numeric_limits<float>::infinity();
    for (const Primitive<Sphere>& each : scene.spheres) {
        const std::optional<Real> t = intersect(ray, each.shape, {});
        if (!t || *t >= smallest) continue;
        closest = &each;
        smallest = float(*t);
    }
    if (closest == nullptr) return background(scene, ray);
    const Vec3 point = at(ray, smallest);
    const Vec3 outward = normal(closest->shape, point);
    if (context.settings.shading == Shading::normal) return color_from_normal(outward);
    return closest->material.color * torch(point, face_forward(outward, ray.direction), ray.origin);
}

}  // namespace rt
