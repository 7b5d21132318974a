// origin: invented: the normal is not turned to the eye
// caught by: inside a sphere, the eye sees what is nearer than its far side (CR §2.1)
// sentence: You light the outside only: from inside a sphere the normal points away from the eye. face_forward turns it.
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
    return closest->material.color * torch(point, outward, ray.origin);
}

}  // namespace rt
