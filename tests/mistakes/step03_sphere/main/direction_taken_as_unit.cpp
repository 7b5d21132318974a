// origin: a student's: the torch by ⟨n, −d⟩
// caught by: the torch lights the closest sphere, at the point that is seen (M1)
// sentence: You take the ray's direction for a unit vector: it is longer away from the middle of the picture. Use torch, or unit(ray.direction).
#include "common/math/vector.hpp"
#include "common/render/stage.hpp"

#include "steps/step03_sphere/sphere.hpp"

namespace rt {

Color trace(const Scene& scene, const Ray& ray, Context& context) {
    ++context.rays;
    const Primitive<Sphere>* closest = nullptr;
    Interval interval;
    for (const Primitive<Sphere>& each : scene.spheres) {
        const std::optional<Real> t = intersect(ray, each.shape, interval);
        if (!t) continue;
        closest = &each;
        interval.max = *t;
    }
    if (closest == nullptr) return background(scene, ray);
    const Vec3 point = at(ray, interval.max);
    const Vec3 outward = normal(closest->shape, point);
    if (context.settings.shading == Shading::normal) return color_from_normal(outward);
    return closest->material.color *
           glm::max(Real(0), dot(face_forward(outward, ray.direction), -ray.direction));
}

}  // namespace rt
