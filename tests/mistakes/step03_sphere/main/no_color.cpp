// origin: invented: the torch alone
// caught by: a sphere that is alone is seen in its color (M1)
// sentence: You return the torch without the color of the sphere: multiply them.
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
    return Color(torch(point, face_forward(outward, ray.direction), ray.origin));
}

}  // namespace rt
