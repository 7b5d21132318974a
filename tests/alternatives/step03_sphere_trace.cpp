// right shortened_interval: the loop of the page: each hit shortens the interval
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
    return closest->material.color * torch(point, face_forward(outward, ray.direction), ray.origin);
}

}  // namespace rt

// right smallest_of_all: every t is compared with the smallest so far
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
    if (closest == nullptr) return background(scene, ray);
    const Vec3 point = at(ray, smallest);
    const Vec3 outward = normal(closest->shape, point);
    if (context.settings.shading == Shading::normal) return color_from_normal(outward);
    return closest->material.color * torch(point, face_forward(outward, ray.direction), ray.origin);
}

}  // namespace rt

// right sorted: all hits in a list, which is sorted
#include "common/math/vector.hpp"
#include "common/render/stage.hpp"

#include "steps/step03_sphere/sphere.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace rt {

Color trace(const Scene& scene, const Ray& ray, Context& context) {
    ++context.rays;
    std::vector<std::pair<Real, const Primitive<Sphere>*>> hits;
    for (const Primitive<Sphere>& each : scene.spheres)
        if (const auto t = intersect(ray, each.shape, Interval{})) hits.emplace_back(*t, &each);
    if (hits.empty()) return background(scene, ray);
    const auto& [t, closest] = *std::min_element(hits.begin(), hits.end());
    const Vec3 point = at(ray, t);
    const Vec3 outward = normal(closest->shape, point);
    if (context.settings.shading == Shading::normal) return color_from_normal(outward);
    return closest->material.color * torch(point, face_forward(outward, ray.direction), ray.origin);
}

}  // namespace rt
