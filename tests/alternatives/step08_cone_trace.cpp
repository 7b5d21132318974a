// right own_loops: a loop for every list, without ClosestHit
#include "common/math/vector.hpp"
#include "common/render/closest_hit.hpp"
#include "common/render/stage.hpp"

#include "steps/step03_sphere/sphere.hpp"
#include "steps/step04_plane/plane.hpp"
#include "steps/step05_triangle/triangle.hpp"
#include "steps/step06_square/square.hpp"
#include "steps/step07_cylinder/cylinder.hpp"
#include "steps/step08_cone/cone.hpp"

namespace rt {

struct Seen {
    const Ray& ray;
    Interval interval{};
    std::optional<Vec3> outward{};
    Color color{0};

    template <class List>
    void test(const List& list) {
        for (std::size_t i = 0; i < list.size(); ++i) {
            const auto& [shape, material] = list[i];
            const auto t = intersect(ray, shape, interval);
            if (!t) continue;
            interval.max = *t;
            outward = normal(shape, at(ray, *t));
            color = material.color;
        }
    }
};

Color trace(const Scene& scene, const Ray& ray, Context& context) {
    ++context.rays;
    Seen seen{.ray = ray};
    seen.test(scene.spheres);
    seen.test(scene.planes);
    seen.test(scene.triangles);
    seen.test(scene.squares);
    seen.test(scene.cylinders);
    seen.test(scene.cones);
    if (!seen.outward) return background(scene, ray);
    if (context.settings.shading == Shading::normal) return color_from_normal(*seen.outward);
    const Vec3 point = at(ray, seen.interval.max);
    return seen.color * torch(point, face_forward(*seen.outward, ray.direction), ray.origin);
}

}  // namespace rt
