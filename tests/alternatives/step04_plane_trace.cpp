// right two_loops: a loop for each list
#include "common/math/vector.hpp"
#include "common/render/closest_hit.hpp"
#include "common/render/stage.hpp"

#include "steps/step03_sphere/sphere.hpp"
#include "steps/step04_plane/plane.hpp"

namespace rt {

Color trace(const Scene& scene, const Ray& ray, Context& context) {
    ++context.rays;
    Interval interval;
    Vec3 outward;
    Color color(0);
    for (const auto& [sphere, material] : scene.spheres)
        if (const auto t = intersect(ray, sphere, interval)) {
            interval.max = *t;
            outward = normal(sphere, at(ray, *t));
            color = material.color;
        }
    for (const auto& [plane, material] : scene.planes)
        if (const auto t = intersect(ray, plane, interval)) {
            interval.max = *t;
            outward = plane.normal;
            color = material.color;
        }
    if (interval.max == infinity) return background(scene, ray);
    if (context.settings.shading == Shading::normal) return color_from_normal(outward);
    const Vec3 point = at(ray, interval.max);
    return color * torch(point, face_forward(outward, ray.direction), ray.origin);
}

}  // namespace rt
