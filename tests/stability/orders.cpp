// Compiled twice: for the references, and for `--precision exact`, which has a ClosestHit of its
// own.
#include "tests/stability/orders.hpp"

#include "common/bvh/mesh_bvh.hpp"
#include "common/explain/text.hpp"
#include "common/render/closest_hit.hpp"
#include "tests/kit/random.hpp"
#include "tests/oracle/inputs.hpp"

#include "steps/step08_cone/all_shapes.hpp"
#include "steps/step13_meshes/mesh_instance.hpp"

#include <cmath>
#include <functional>
#include <memory>
#include <variant>
#include <vector>

namespace rt {

namespace {

/// A triangle of a mesh.
struct Face {
    Triangle triangle;
};

using Shape = std::variant<Sphere, Plane, Triangle, Square, Cylinder, Cone, Face>;

Face transformed(const Face& face, const Transform& transform) {
    return {transformed(face.triangle, transform)};
}

std::string code(const Face& face) {
    return "a mesh's " + code(face.triangle);
}

oracle::Triangle exact(const Face& face) {
    return rt::exact(face.triangle);
}

Shape transformed(const Shape& shape, Vec3 way) {
    return std::visit(
        [&](const auto& one) { return Shape(transformed(one, Transform{.translation = way})); },
        shape);
}

/// The exact first intersection of the ray and the shape, to a hundred digits.
oracle::Number exact_t(const Ray& ray, const Shape& shape) {
    const auto root = std::visit(
        [&](const auto& one) { return intersect(exact(ray), exact(one), oracle::Interval{}); },
        shape);
    return root.value().value();
}

// Returns the closer one according to ClosestHit: the shapes have the materials 1 and 2.

Mesh mesh_of(const std::vector<Triangle>& triangles) {
    Mesh mesh;
    for (const Triangle& triangle : triangles) {
        const auto first = std::uint32_t(mesh.vertices.size());
        mesh.triangles.push_back({first, first + 1, first + 2});
        for (const Vec3& corner : {triangle.a, triangle.b, triangle.c})
            mesh.vertices.push_back(corner);
    }
    return mesh;
}

/// The shape in a scene.
template <class One>
One in_scene(const One& shape) {
    return shape;
}

MeshInstance in_scene(const Face& face) {
    MeshGeometry model{.mesh = mesh_of({face.triangle})};
    model.bounds = bounds(model.mesh);
    model.packed.emplace(model.mesh);
    return {.model = std::make_shared<const MeshGeometry>(std::move(model)), .placement = {}};
}

constexpr Real far = 64;  ///< from the ray, where others are

enum class Way { list, balls, hierarchy };

const char* name(Way way) {
    return way == Way::list ? "a list" : way == Way::balls ? "balls" : "a hierarchy";
}

/// The shapes of one kind, the first with this material; with additional shapes if a BVH is
/// required, which never contains planes.
template <class One>
auto items_of(const std::vector<One>& shapes, Way way, Real material) {
    PrimitiveList<decltype(in_scene(shapes[0]))> primitives;
    for (const One& shape : shapes) {
        primitives.push_back({.shape = in_scene(shape), .material = {.mirror = material}});
        ++material;
        const bool others = way == Way::hierarchy && !std::is_same_v<One, Plane>;
        for (Real i = 0; i < 8 && others; ++i) {
            const Transform aside{.translation = Vec3(far, far, material * far + i)};
            primitives.push_back({.shape = in_scene(transformed(shape, aside)), .material = {}});
        }
    }
    if (way == Way::balls) primitives.build_acceleration({.hierarchy_from = Acceleration::never});
    if (way == Way::hierarchy) primitives.build_acceleration({.hierarchy_from = 1});
    return primitives;
}

int nearest_of_faces(const Ray& ray, const Face& first, const Face& second, Way way) {
    std::vector<Triangle> triangles = {first.triangle};
    for (Real i = 0; i < 40 && way == Way::hierarchy; ++i)
        triangles.push_back(transformed(first.triangle, {.translation = Vec3(far, far, i)}));
    triangles.push_back(second.triangle);
    const auto hit = MeshBvh(mesh_of(triangles)).nearest(ray, {});
    return !hit ? 0 : hit->triangle == 0 ? 1 : 2;
}

/// The test of shapes of one kind.
using Test = std::function<void(ClosestHit&)>;

template <class One>
Test test_of(const std::vector<One>& shapes, Way way, Real material) {
    return [items = std::make_shared<const decltype(items_of(shapes, way, material))>(
                items_of(shapes, way, material))](ClosestHit& closest) { closest.test(*items); };
}

int nearest_of(const Ray& ray, const std::vector<Test>& tests) {
    Context context;
    ClosestHit closest(ray, context);
    for (const Test& test : tests) test(closest);
    const auto hit = closest.hit();
    return hit ? int(hit->material->mirror) : 0;
}

int nearest_of(const Ray& ray, const Shape& first, const Shape& second, Way way) {
    if (first.index() != second.index()) {
        const auto alone = [&](const Shape& shape, Real material) {
            return std::visit(
                [&](const auto& one) { return test_of(std::vector{one}, way, material); }, shape);
        };
        return nearest_of(ray, {alone(first, 1), alone(second, 2)});
    }
    return std::visit(
        [&]<class One>(const One& one) {
            const One& other = std::get<One>(second);
            if constexpr (std::is_same_v<One, Face>) return nearest_of_faces(ray, one, other, way);
            return nearest_of(ray, {test_of(std::vector{one, other}, way, 1)});
        },
        first);
}

void ask(const Ray& ray, const Shape& first, const Shape& second, bool first_is_nearer,
         Orders& orders) {
    for (const Way way : {Way::list, Way::balls, Way::hierarchy}) {
        const int got = nearest_of(ray, first, second, way);
        ++orders.asked;
        if (got == (first_is_nearer ? 1 : 2)) continue;
        if (orders.wrong++ != 0) continue;
        const auto printed = [](const auto& one) { return code(one); };
        orders.where = "ray:    " + code(ray) + "\nfirst:  " + std::visit(printed, first) +
                       "\nsecond: " + std::visit(printed, second) + "\nnearer: the " +
                       (first_is_nearer ? "first" : "second") + ", but came " +
                       std::to_string(got) + " of " + name(way);
    }
}

// Shapes that a ray hits at a point first. Much smaller than t, so that their last digits move t
// by far less than an ulp.

constexpr Real size = Real(1) / 64;

/// At right angles to a unit vector.
Vec3 across(Random& random, Vec3 v) {
    return unit(cross(v, random.direction()));
}

/// Outwards, at the ray's entry.
Vec3 outward(Random& random, Vec3 direction) {
    const Vec3 normal = random.direction();
    return dot(normal, direction) < 0 ? normal : -normal;
}

Triangle triangle_around(Random& random, Vec3 point) {
    const Vec3 ab = size * random.direction();
    const Vec3 ac = size * random.direction();
    return {.a = point - (ab + ac) / Real(3),
            .b = point + (ab + ab - ac) / Real(3),
            .c = point + (ac + ac - ab) / Real(3)};
}

Shape drawn(Random& random, std::size_t kind, const Ray& ray, Vec3 point) {
    const Vec3 normal = outward(random, ray.direction);
    const Vec3 axis = across(random, normal);
    if (kind == 0) return Sphere{.center = point - size * normal, .radius = size};
    if (kind == 1) return Plane{.point = point, .normal = normal};
    if (kind == 2) return triangle_around(random, point);
    if (kind == 3) return Square{.center = point, .basis = random.basis(), .side = size};
    if (kind == 4)
        return Cylinder{
            .center = point - size * normal, .axis = axis, .radius = size, .height = size};
    if (kind == 5)  // half-way down a cone that is as wide as high
        return Cone{.apex = point - size / std::sqrt(Real(2)) * axis,
                    .axis = unit(axis - normal),
                    .radius = size,
                    .height = size};
    return Face{triangle_around(random, point)};
}

/// The shape, moved until the ray hits it at t, or as close to that as possible.
Shape moved_to(Random& random, Shape shape, const Ray& ray, const oracle::Number& t, Real ulp) {
    const auto off = [&](const Shape& one) {
        return oracle::Number((exact_t(ray, one) - t) / ulp).convert_to<Real>();
    };
    shape = transformed(shape, -off(shape) * ulp * ray.direction);
    Real least = off(shape);
    for (int i = 0; i < 40 && std::abs(least) > Real(1e-4); ++i) {
        const Real step = std::pow(Real(10), random.between(-3, 1)) * ulp;
        const Shape other = transformed(shape, step * random.direction());
        const Real left = off(other);
        if (std::abs(left) >= std::abs(least)) continue;
        shape = other;
        least = left;
    }
    return shape;
}

void ask_near_ties(Random& random, std::size_t kind, std::size_t other_kind, Orders& orders) {
    for (const Real apart : {Real(1e-3), Real(0.5), Real(1), Real(4)}) {
        Ray ray{.direction = random.between(Real(0.5), 2) * random.direction()};
        const Vec3 point = random.point(size);
        ray.origin = point - random.between(2, 10) * ray.direction;
        const Shape one = drawn(random, kind, ray, point);
        const oracle::Number t = exact_t(ray, one);
        const Real rounded = t.convert_to<Real>();
        const Real ulp = std::nextafter(rounded, infinity) - rounded;
        const Shape drawn_there = drawn(random, other_kind, ray, point);
        const Shape other = moved_to(random, drawn_there, ray, t + apart * ulp, ulp);
        const bool is_nearer = t <= exact_t(ray, other);
        ask(ray, one, other, is_nearer, orders);
        ask(ray, other, one, !is_nearer, orders);
    }
}

}  // namespace

Orders orders_of_near_ties(std::uint64_t times) {
    Orders orders;
    Random random(2021);
    constexpr std::size_t kinds = std::variant_size_v<Shape>;
    for (std::uint64_t i = 0; i < times; ++i)
        for (std::size_t kind = 0; kind < kinds; ++kind)
            for (std::size_t other = 0; other < kinds; ++other)
                ask_near_ties(random, kind, other, orders);
    return orders;
}

Orders orders_of_ties() {
    const Ray ray{.origin = {0, 0, 5}, .direction = {0, 0, -1}};
    const Vec3 x(1, 0, 0);
    const Triangle whole{.a = {3, 0, 2}, .b = {-3, 3, 0}, .c = {-3, -3, 0}};
    const Triangle half{.a = {3, 0, 2}, .b = {-3, 0, 0}, .c = {0, 5, 0}};
    const std::vector<Shape> at_four = {
        Sphere{.center = {0, 0, 0}, .radius = 1},
        Sphere{.center = {2, 0, 1}, .radius = 2},
        Plane{.point = {1, 1, 0}, .normal = {0, 1, 1}},
        Plane{.point = {3, 2, 1}, .normal = {2, -3, 9}},
        whole,
        half,
        Square{.center = {0, 0, 1}, .basis = {}, .side = 2},
        Square{.center = {0, 2, 1}, .basis = {.x = -x, .y = {0, -1, 0}}, .side = 4},
        Cylinder{.center = {0, 0, -1}, .axis = x, .radius = 2, .height = 4},
        Cylinder{.center = {2, 0, -2}, .axis = -x, .radius = 3, .height = 5},
        Cone{.apex = {-1, 0, 0}, .axis = x, .radius = 4, .height = 4},
        Cone{.apex = {4, 0, -1}, .axis = -x, .radius = 3, .height = 6},
        Face{whole},
        Face{half}};
    const std::vector<Shape> at_root = {
        Sphere{.center = {1, 0, 0}, .radius = 2},
        Sphere{.center = {0, -1, 0}, .radius = 2},
        Cylinder{.center = {0, 1, 0}, .axis = x, .radius = 2, .height = 8},
        Cylinder{.center = {3, -1, 0}, .axis = x, .radius = 2, .height = 7},
        Cone{.apex = {-2, 1, 0}, .axis = x, .radius = 8, .height = 8},
        Cone{.apex = {-1, -1, 0}, .axis = x, .radius = 8, .height = 4}};
    Orders orders;
    for (const auto* shapes : {&at_four, &at_root})
        for (const Shape& one : *shapes)
            for (const Shape& other : *shapes) {
                const bool is_tie = abs(exact_t(ray, one) - exact_t(ray, other)) < 1e-90;
                if (is_tie) ask(ray, one, other, true, orders);
            }
    return orders;
}

}  // namespace rt
