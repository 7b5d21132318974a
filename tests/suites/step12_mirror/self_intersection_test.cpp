// The reflected ray misses the surface that it leaves (erratum 31).
#include "steps/step12_mirror/mirror.hpp"

#include "common/render/closest_hit.hpp"

#include "steps/step08_cone/all_shapes.hpp"

#include "tests/suites/step12_mirror/question.hpp"

#include <cmath>

using namespace rt;

namespace {

/// A shape of size 1 or so at the origin, one of each kind there is.
Scene draw_shape(Random& random) {
    const Basis basis = random.basis();
    const Real height = random.between(1, 3);
    Scene scene;
    switch (random.below(6)) {
        case 0:
            scene.spheres.push_back({.shape = {.center = {0, 0, 0}, .radius = 1}});
            break;
        case 1:
            scene.planes.push_back({.shape = {.point = {0, 0, 0}, .normal = basis.z}});
            break;
        case 2:
            scene.triangles.push_back({.shape = {basis.x, basis.y, -basis.x - basis.y}});
            break;
        case 3:
            scene.squares.push_back({.shape = {.center = {0, 0, 0}, .basis = basis, .side = 1}});
            break;
        case 4:
            scene.cylinders.push_back({.shape = {.axis = basis.z, .radius = 1, .height = height}});
            break;
        default:
            scene.cones.push_back({.shape = {.apex = -height / 2 * basis.z,
                                             .axis = basis.z,
                                             .radius = 1,
                                             .height = height}});
    }
    return scene;
}

template <class Shape>
PrimitiveList<Shape> moved_items(const PrimitiveList<Shape>& primitives,
                                 const Transform& transform) {
    PrimitiveList<Shape> result;
    for (const Primitive<Shape>& primitive : primitives)
        result.push_back({.shape = transformed(primitive.shape, transform)});
    return result;
}

Scene moved_scene(const Scene& scene, const Transform& transform) {
    Scene result;
    result.spheres = moved_items(scene.spheres, transform);
    result.planes = moved_items(scene.planes, transform);
    result.triangles = moved_items(scene.triangles, transform);
    result.squares = moved_items(scene.squares, transform);
    result.cylinders = moved_items(scene.cylinders, transform);
    result.cones = moved_items(scene.cones, transform);
    return result;
}

std::string code_of_shape(const Scene& scene) {
    if (!scene.spheres.empty()) return code(scene.spheres.front().shape);
    if (!scene.planes.empty()) return code(scene.planes.front().shape);
    if (!scene.triangles.empty()) return code(scene.triangles.front().shape);
    if (!scene.squares.empty()) return code(scene.squares.front().shape);
    if (!scene.cylinders.empty()) return code(scene.cylinders.front().shape);
    return code(scene.cones.front().shape);
}

std::optional<Hit> first_hit(const Scene& scene, const Ray& ray) {
    Context context;
    ClosestHit closest(ray, context);
    visit_shapes(closest, scene);
    return closest.hit();
}

/// The ray hits the shape; the reflected ray does not hit it again where it left, within a
/// hundredth of its size. (Seen from inside, it does hit it farther away.)
Verdict leaves(const Scene& scene, const Ray& ray, Real size) {
    const std::optional<Hit> hit = first_hit(scene, ray);
    if (!hit) return {};
    // Inside a cone's tip the other side is as near as one likes.
    if (!scene.cones.empty() && distance(hit->point, scene.cones.front().shape.apex) < size / 4)
        return {};
    const ShadingPoint surface = shading_point(*hit, ray);
    const Ray sent = mirrored(ray, surface);
    const std::optional<Hit> next = first_hit(scene, sent);
    const Real way = next ? next->t * length(sent.direction) : infinity;
    return verdict(way > size / 100 * std::abs(dot(unit(ray.direction), surface.geometric_normal)),
                   question(ray, surface) + ",\n           which it sends on from " +
                       code_of_shape(scene) + "\n  got:      " + code(sent) +
                       ", which hits it again after " + text(way) +
                       "\n  expected: it leaves the surface, and misses it there");
}

}  // namespace

TEST_CASE("the reflected ray misses the surface that it leaves, at any scale (erratum 31)") {
    // Sizes from 1e-6 to 1e6. The sphere is seen from inside, where a constant offset is past the
    // other side of a small one and lost in the rounding of a large one.
    const auto other_side_is_hit = [](Real size, Vec3 center, Vec3 direction) {
        const Sphere sphere{.center = size * center, .radius = size};
        const Ray ray{.origin = sphere.center, .direction = direction};
        Scene scene;
        scene.spheres.push_back({.shape = sphere});
        const ShadingPoint surface = shading_point(first_hit(scene, ray).value(), ray);
        const Ray sent = mirrored(ray, surface);
        const std::optional<Hit> other_side = first_hit(scene, sent);
        const Real way = other_side ? other_side->t * length(sent.direction) : infinity;
        return gives("the way, in radii, on which " + question(ray, surface) +
                         "\n  comes to the other side of " + code(sphere),
                     way / size, Real(2));
    };
    Verdict across_it;
    for (int exponent = -6; across_it && exponent <= 6; ++exponent)
        across_it = other_side_is_hit(std::pow(Real(10), Real(exponent)), {3, 2, 0}, {3, 4, 0});
    CHECK(across_it);
    CHECK(for_all([other_side_is_hit](Random& random) {
        const Real size = std::pow(Real(10), Real(random.below(13) - 6));
        const Vec3 center = random.point(3);
        return other_side_is_hit(size, center, random.between(1, 5) * random.direction());
    }));
    CHECK(for_all(
        [](Random& random) {
            Transform transform;
            transform.scale = std::pow(Real(10), Real(random.below(13) - 6));
            transform.rotation = random.basis();
            transform.translation = transform.scale * random.point(8);
            const Vec3 eye = random.point(4);
            const Vec3 aim = random.point(1);
            // Any length relative to the scene: in float, the products stay far from underflow.
            const Ray ray{.origin = transformed(eye, transform),
                          .direction = random.power_of_two() * rotated(aim - eye, transform)};
            return leaves(moved_scene(draw_shape(random), transform), ray, transform.scale);
        },
        2000));
}
