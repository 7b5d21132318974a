// origin: invented: a large number in place of infinity
// caught by: a sphere that is alone is seen in its color (M1)
// sentence: Your smallest t begins at a large number: what is farther away is not seen. It begins at infinity.
#include "common/math/vector.hpp"
#include "common/render/stage.hpp"

#include "steps/step03_sphere/sphere.hpp"

namespace rt {

Color trace(const Scene& scene, const Ray& ray, Context& context) {
    ++context.rays;
    const Primitive<Sphere>* closest = nullptr;
    Real smallest = 1e9;
    for (const Primitive<Sphere>& each : scene.spheres) {
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
