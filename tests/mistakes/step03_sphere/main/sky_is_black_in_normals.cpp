// origin: a student's: black without a hit with --shade normal
// caught by: with --shade normal, trace shows the normal of the closest sphere (M1)
// sentence: Without a hit, --shade normal shows the background as well.
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
    if (closest == nullptr)
        return context.settings.shading == Shading::normal ? Color(0) : background(scene, ray);
    const Vec3 point = at(ray, interval.max);
    const Vec3 outward = normal(closest->shape, point);
    if (context.settings.shading == Shading::normal) return color_from_normal(outward);
    return closest->material.color * torch(point, face_forward(outward, ray.direction), ray.origin);
}

}  // namespace rt
