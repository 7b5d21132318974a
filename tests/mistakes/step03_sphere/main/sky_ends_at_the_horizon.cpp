// origin: invented: below the horizon one color
// caught by: without a hit the pixel is the color of the scene's sky in the ray's direction
// sentence: Below the horizon your sky has one color. It changes from straight down to straight up: background(scene, ray).
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
        if (!t || *t >= smallest) continue;
        closest = &each;
        smallest = *t;
    }
    if (closest == nullptr)
        return scene.sky ? (ray.direction.y >= 0 ? background(scene, ray) : scene.sky->bottom)
                         : Color(0);
    const Vec3 point = at(ray, smallest);
    const Vec3 outward = normal(closest->shape, point);
    if (context.settings.shading == Shading::normal) return color_from_normal(outward);
    return closest->material.color * torch(point, face_forward(outward, ray.direction), ray.origin);
}

}  // namespace rt
