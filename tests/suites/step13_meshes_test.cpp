// Stage 13 against M1 (boxes, change of frame), CR §4.2 and §6, and HAI (transforms).
#include "steps/step13_meshes/meshes.hpp"

#include "common/geometry/bounds.hpp"
#include "common/render/closest_hit.hpp"
#include "common/render/stage.hpp"

#include "steps/step05_triangle/triangle.hpp"
#include "steps/step13_meshes/mesh_instance.hpp"

#include "tests/kit/light.hpp"
#include "tests/kit/picture.hpp"
#include "tests/kit/shape_checks.hpp"

#include <algorithm>
#include <map>

using namespace rt;

namespace {

// Boxes along the axes.

/// From (-1, -2, -3) to (1, 2, 3).
const BoundingBox block{.min = {-1, -2, -3}, .max = {1, 2, 3}};

std::string got_text(const std::optional<Interval>& part) {
    return part ? "inside from t = " + text(part->min) + " to " + text(part->max) : "never inside";
}

Verdict told(const Ray& ray, const BoundingBox& box, Interval interval,
             const std::optional<Interval>& expected) {
    const auto got = overlap(ray, box, interval);
    const bool same =
        expected ? got && close(got->min, expected->min, 0) && close(got->max, expected->max, 0)
                 : !got;
    const std::string question = code(ray) + ", " + code(box);
    const std::string paste =
        expected ? "inside(" + question + ", " + code(*expected) : "outside(" + question;
    const bool whole = interval.min == 0 && interval.max == infinity;
    return verdict(same, "overlap(" + code(ray) + ",\n        " + code(box) + ",\n        " +
                             code(interval) + ")\n  got:      " + got_text(got) +
                             "\n  expected: " + got_text(expected) + "\n  paste:    CHECK(" +
                             paste + (whole ? "" : ", " + code(interval)) + "));");
}

/// The ray is in the box for just this part of the interval.
Verdict inside(const Ray& ray, const BoundingBox& box, Interval expected, Interval interval = {}) {
    return told(ray, box, interval, expected);
}

/// The ray is nowhere in the box inside the interval.
Verdict outside(const Ray& ray, const BoundingBox& box, Interval interval = {}) {
    return told(ray, box, interval, std::nullopt);
}

/// A point of a box's face, a tenth of the box away from the others. The faces are 0 to 5.
Vec3 draw_on_face(Random& random, const BoundingBox& box, int face) {
    const glm::length_t axis = face / 2;
    Vec3 share;
    for (glm::length_t i = 0; i < 3; ++i) share[i] = random.between(Real(0.1), Real(0.9));
    share[axis] = Real(face % 2);
    return box.min + share * (box.max - box.min);
}

/// A line that enters the box at t = 0 and leaves it at t = 1: from one face to another.
struct Chord {
    BoundingBox box;
    Ray line;
};

Chord draw_chord(Random& random) {
    const Vec3 corner = random.point(3);
    const Vec3 size = Vec3(1) + abs(random.point(1));
    const BoundingBox box{.min = corner, .max = corner + size};
    const int face = random.below(6);
    const Vec3 enters = draw_on_face(random, box, face);
    const Vec3 leaves = draw_on_face(random, box, (face + 1 + random.below(5)) % 6);
    return {.box = box, .line = {.origin = enters, .direction = leaves - enters}};
}

// Oriented boxes.

/// Around (0, 0, -5), half as wide, high and deep as 2, 4, 6; along the axes.
const OrientedBox upright{.center = {0, 0, -5}, .half_size = {1, 2, 3}};

/// At most 0.9 of the way to an edge.
Sample<OrientedBox> draw_box(Random& random) {
    const Basis basis = random.basis();
    const Vec3 half_size = Vec3(Real(0.5)) + abs(random.point(1));
    const std::array<Vec3, 3> axes = {basis.x, basis.y, basis.z};
    const auto face = glm::length_t(random.below(3));
    const Real sign = random.coin() ? 1 : -1;
    Vec3 share = random.point(Real(0.9));
    share[face] = sign;
    const OrientedBox box{.center = random.point(3), .basis = basis, .half_size = half_size};
    const Vec3 p = share * half_size;
    return {.shape = box,
            .point = box.center + p.x * basis.x + p.y * basis.y + p.z * basis.z,
            .normal = sign * axes[std::size_t(face)]};
}

/// In eighths, along the axes, half sizes powers of two from 1: with rays along or across them
/// nothing is rounded.
OrientedBox draw_box_in_eighths(Random& random) {
    return {.center = random.point_in_eighths(3),
            .basis = random.axes(),
            .half_size = Vec3(1 << random.below(3), 1 << random.below(3), 1 << random.below(3))};
}

// Meshes.

/// C++ that creates the mesh.
std::string mesh_code(const Mesh& mesh) {
    std::string vertices;
    for (const Vec3& v : mesh.vertices) vertices += (vertices.empty() ? "" : ", ") + code(v);
    std::string triangles;
    for (const auto& [a, b, c] : mesh.triangles)
        triangles += std::string(triangles.empty() ? "" : ", ") + "{" + std::to_string(a) + ", " +
                     std::to_string(b) + ", " + std::to_string(c) + "}";
    return "Mesh{.vertices = {" + vertices + "}, .triangles = {" + triangles + "}}";
}

std::string got_text(const std::optional<MeshHit>& hit) {
    return hit ? "triangle " + std::to_string(hit->triangle) + " at t = " + text(hit->t) +
                     ", weights " + text(hit->weights)
               : "no hit";
}

std::string mesh_told(const Ray& ray, const Mesh& mesh, Interval interval,
                      const std::optional<MeshHit>& got, const std::optional<MeshHit>& expected) {
    const bool whole = interval.min == 0 && interval.max == infinity;
    const std::string last = whole ? "));" : ", " + code(interval) + "));";
    const std::string asked = code(ray) + ", " + mesh_code(mesh);
    const std::string paste = expected ? "meets(" + asked + ", {.t = " + code(expected->t) +
                                             ", .triangle = " + std::to_string(expected->triangle) +
                                             ", .weights = " + code(expected->weights) + "}"
                                       : "misses_mesh(" + asked;
    return "intersect(" + code(ray) + ",\n          " + mesh_code(mesh) + ",\n          " +
           code(interval) + ")\n  got:      " + got_text(got) +
           "\n  expected: " + got_text(expected) + "\n  paste:    CHECK(" + paste + last;
}

/// The ray first meets this triangle of the mesh there.
Verdict meets(const Ray& ray, const Mesh& mesh, const MeshHit& expected, Interval interval = {}) {
    const auto got = intersect(ray, mesh, interval);
    const bool same = got && close(got->t, expected.t, 0) && got->triangle == expected.triangle &&
                      close(got->weights, expected.weights);
    return verdict(same, mesh_told(ray, mesh, interval, got, expected));
}

Verdict misses_mesh(const Ray& ray, const Mesh& mesh, Interval interval = {}) {
    const auto got = intersect(ray, mesh, interval);
    return verdict(!got, mesh_told(ray, mesh, interval, got, std::nullopt));
}

/// Two triangles one before the other, the closer one second, of five vertices one of which is
/// unused: a ray down the z axis has weights ½, ¼, ¼ in both.
const Mesh layers{
    .vertices = {{9, 9, 9}, {0, 1, 0}, {-1, -1, 0}, {1, -1, 0}, {0, 1, 2}, {-1, -1, 2}, {1, -1, 2}},
    .triangles = {{1, 2, 3}, {4, 5, 6}}};

const Ray down_z{.origin = {0, 0, 5}, .direction = {0, 0, -1}};
const Vec3 half_and_quarters{Real(0.5), Real(0.25), Real(0.25)};

/// Triangles across a line, some of them moved aside, their vertices shuffled in one list.
struct Stack {
    Mesh mesh;
    Ray line;
    std::vector<MeshHit> crossed;  ///< along the line, closest first
};

/// A triangle around the point, which has these weights in it.
Triangle triangle_around(Random& random, Vec3 point, const Basis& basis, Vec3 weights) {
    const auto aside = [&](Real angle) {
        return random.between(1, 2) * (std::cos(angle) * basis.x + std::sin(angle) * basis.y) +
               random.between(Real(-0.2), Real(0.2)) * basis.z;
    };
    const Real angle = random.between(-pi, pi);
    const Vec3 to_a = aside(angle);
    const Vec3 to_b = aside(angle + 2);
    return {.a = point + to_a,
            .b = point + to_b,
            .c = point - (weights.x * to_a + weights.y * to_b) / weights.z};
}

Stack draw_stack(Random& random) {
    const Basis basis = random.basis();
    const int count = 1 + random.below(6);
    Stack stack{.line = {.origin = random.point(2), .direction = basis.z}};
    // The heights 2, 4, …, in any order; and vertices put in anywhere, 3 of them in no triangle.
    std::vector<int> heights(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) heights[std::size_t(i)] = 2 * (i + 1);
    for (std::size_t i = heights.size() - 1; i > 0; --i)
        std::swap(heights[i], heights[std::size_t(random.below(int(i) + 1))]);
    std::vector<std::uint32_t> places(3 * heights.size() + 3);
    for (std::size_t i = 0; i < places.size(); ++i) places[i] = std::uint32_t(i);
    for (std::size_t i = places.size() - 1; i > 0; --i)
        std::swap(places[i], places[std::size_t(random.below(int(i) + 1))]);
    stack.mesh.vertices.assign(places.size(), Vec3(0));
    for (std::size_t i = 0; i < heights.size(); ++i) {
        Vec3 weights(random.between(Real(0.15), Real(0.4)), random.between(Real(0.15), Real(0.4)),
                     0);
        weights.z = 1 - weights.x - weights.y;
        const bool crossed = random.below(4) > 0;
        const Vec3 point = at(stack.line, Real(heights[i]));
        const Triangle triangle =
            triangle_around(random, crossed ? point : point + Real(20) * basis.x, basis, weights);
        const std::uint32_t* place = &places[3 * i];
        stack.mesh.triangles.push_back({place[0], place[1], place[2]});
        stack.mesh.vertices[place[0]] = triangle.a;
        stack.mesh.vertices[place[1]] = triangle.b;
        stack.mesh.vertices[place[2]] = triangle.c;
        if (crossed)
            stack.crossed.push_back(
                {.t = Real(heights[i]), .triangle = std::uint32_t(i), .weights = weights});
    }
    std::ranges::sort(stack.crossed, {}, &MeshHit::t);
    return stack;
}

/// From (-1, -1, -1) to (1, 1, 1): twelve triangles, few enough to be tested one by one.
Mesh cube() {
    Mesh mesh;
    for (int i = 0; i < 8; ++i)
        mesh.vertices.emplace_back((i & 1) * 2 - 1, (i & 2) - 1, (i & 4) / 2 - 1);
    mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return mesh;
}

Mesh octahedron() {
    return {.vertices = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
            .triangles = {{0, 2, 4},
                          {2, 1, 4},
                          {1, 3, 4},
                          {3, 0, 4},
                          {2, 0, 5},
                          {1, 2, 5},
                          {3, 1, 5},
                          {0, 3, 5}}};
}

/// Four triangles for one, and the vertices on the unit sphere: 128, many enough to be packed.
Mesh ball() {
    Mesh mesh = octahedron();
    for (int i = 0; i < 2; ++i) {
        Mesh finer{.vertices = mesh.vertices};
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
        const auto middle = [&](std::uint32_t p, std::uint32_t q) {
            const auto [found, is_new] =
                middles.try_emplace(std::minmax(p, q), std::uint32_t(finer.vertices.size()));
            if (is_new) finer.vertices.push_back(unit(mesh.vertices[p] + mesh.vertices[q]));
            return found->second;
        };
        for (const auto& [a, b, c] : mesh.triangles) {
            const std::uint32_t ab = middle(a, b);
            const std::uint32_t bc = middle(b, c);
            const std::uint32_t ca = middle(c, a);
            finer.triangles.push_back({a, ab, ca});
            finer.triangles.push_back({ab, b, bc});
            finer.triangles.push_back({ca, bc, c});
            finer.triangles.push_back({ab, bc, ca});
        }
        mesh = finer;
    }
    return mesh;
}

// Placed meshes.

enum class Asked { one_by_one, packed };

std::shared_ptr<const MeshGeometry> model_of(const Mesh& mesh, Asked asked = Asked::one_by_one) {
    MeshGeometry model{.mesh = mesh, .bounds = bounds(mesh)};
    if (asked == Asked::packed) model.packed.emplace(mesh);
    return std::make_shared<const MeshGeometry>(std::move(model));
}

std::string placed_code(const MeshInstance& instance) {
    const auto& [mesh, bounds, packed] = *instance.model;
    return (packed ? "packed: " : "") +
           (mesh.triangles.size() > 12 ? "the ball" : mesh_code(mesh)) + ", " +
           code(instance.placement);
}

/// The nearest triangle of a placed mesh is met at t, at this point of the scene.
Verdict meets_placed(const Ray& ray, const MeshInstance& instance, Real t, Vec3 point) {
    const auto got = intersect(ray, instance, {});
    const Real size = instance.placement.scale;
    const bool same =
        got && close(got->t, t, 0) && close(snapped_to(instance, *got).point / size, point / size);
    return verdict(same, "intersect(" + code(ray) + ",\n          " + placed_code(instance) +
                             ")\n  got:      " + got_text(got) + "\n  expected: t = " + text(t) +
                             ", at " + text(point));
}

/// A ray aimed at a point that triangles of a convex mesh share, in the mesh's frame: from inside,
/// or from outside and before all of these triangles.
Ray draw_shot(Random& random, const Mesh& mesh) {
    const auto& corners = mesh.triangles[std::size_t(random.below(int(mesh.triangles.size())))];
    const int first = random.below(3);
    const std::uint32_t p = corners[std::size_t(first)];
    const std::uint32_t q = random.coin() ? p : corners[std::size_t((first + 1) % 3)];
    const Vec3 aim = mesh.vertices[p] +
                     random.between(Real(0.05), Real(0.95)) * (mesh.vertices[q] - mesh.vertices[p]);
    if (random.coin()) {
        const Vec3 origin = random.point(Real(0.25));
        return {.origin = origin, .direction = aim - origin};
    }
    Vec3 outward(0);
    for (const auto& around : mesh.triangles) {
        if (std::ranges::count(around, p) == 0 || std::ranges::count(around, q) == 0) continue;
        const Vec3& a = mesh.vertices[around[0]];
        outward += unit(cross(mesh.vertices[around[1]] - a, mesh.vertices[around[2]] - a));
    }
    const Vec3 away = Real(2) * unit(outward) + Real(0.8) * random.direction();
    const Vec3 origin = aim + random.between(Real(0.25), 2) * away;
    return {.origin = origin, .direction = aim - origin};
}

Verdict none_lost(const Mesh& mesh, Asked asked) {
    const auto model = model_of(mesh, asked);
    return for_all(
        [model](Random& random) {
            const Ray shot = draw_shot(random, model->mesh);
            const MeshInstance instance{.model = model, .placement = random_motion(random)};
            return meets_placed(transformed(shot, instance.placement), instance, 1,
                                transformed(at(shot, 1), instance.placement));
        },
        2000);
}

// Scenes.

const Ambient everywhere{.ratio = 1};  // a lit surface shows its own color
const Color red{1, Real(0.25), 0};
const Color blue{0, Real(0.25), 1};

Verdict sees(const std::string& what, const Scene& scene, const Ray& ray, Color expected) {
    Context context;
    return gives("trace(" + what + ", " + code(ray) + ")", trace(scene, ray, context), expected);
}

}  // namespace

TEST_CASE("a ray is in the box from the last t_min to the first t_max (M1)", "[3 points]") {
    CHECK(inside(Ray{.origin = {0, 0, 5}, .direction = {0, 0, -1}}, block, {2, 8}));
    // Through x in 4 to 6, y in 3 to 7, z in 2 to 8.
    CHECK(inside(Ray{.origin = {5, 5, 5}, .direction = {-1, -1, -1}}, block, {4, 6}));
    CHECK(inside(Ray{.origin = {-5, -5, -5}, .direction = {1, 1, 1}}, block, {4, 6}));
    CHECK(inside(Ray{.origin = {5, -5, 5}, .direction = {-1, 1, -1}}, block, {4, 6}));
    // In by one face, out by another: x in 1 to 3, y in 0 to 4, z always.
    CHECK(inside(Ray{.origin = {2, -2, 0}, .direction = {-1, 1, 0}}, block, {1, 3}));
    CHECK(for_all([](Random& random) {
        const auto [box, line] = draw_chord(random);
        const Real before = random.between(Real(0.1), 2);
        return inside({.origin = at(line, -before), .direction = line.direction}, box,
                      {before, before + 1});
    }));
}

TEST_CASE("a ray that leaves one slab before it enters another misses (M1)") {
    // x in 1 to 3, y in 4 to 8.
    CHECK(outside(Ray{.origin = {2, -6, 0}, .direction = {-1, 1, 0}}, block));
    CHECK(outside(Ray{.origin = {2, 0, 5}, .direction = {0, 0, -1}}, block));
    CHECK(outside(Ray{.origin = {0, -3, 5}, .direction = {0, 0, -1}}, block));
    CHECK(for_all([](Random& random) {
        // Through a point beside a face, and further away from it on one side and on the other.
        const auto [box, line] = draw_chord(random);
        const int face = random.below(6);
        const glm::length_t axis = face / 2;
        Vec3 point = draw_on_face(random, box, face);
        point[axis] += (face % 2 == 0 ? -1 : 1) * random.between(Real(0.1), 1);
        Vec3 direction = random.direction();
        direction[axis] = 0;
        if (direction == Vec3(0)) direction[(axis + 1) % 3] = 1;
        return outside({.origin = point - Real(4) * direction, .direction = direction}, box);
    }));
}

TEST_CASE("t counts in the length of the direction, however short or long it is (PHY, any v)") {
    CHECK(for_all([](Random& random) {
        const auto [box, line] = draw_chord(random);
        const Real length = std::ldexp(Real(1), random.below(81) - 40);
        return inside({.origin = at(line, -1), .direction = length * line.direction}, box,
                      {1 / length, 2 / length});
    }));
}

TEST_CASE("a box behind the eye is missed (erratum 8, M1)") {
    const BoundingBox behind{.min = {-1, -1, 4}, .max = {1, 1, 6}};
    CHECK(outside(Ray{.origin = {0, 0, 0}, .direction = {0, 0, -1}}, behind));
    CHECK(inside(Ray{.origin = {0, 0, 0}, .direction = {0, 0, 1}}, behind, {4, 6}));
    CHECK(for_all([](Random& random) {
        const auto [box, line] = draw_chord(random);
        const Real before = random.between(Real(0.1), 2);
        return outside({.origin = at(line, -before), .direction = -line.direction}, box);
    }));
}

TEST_CASE("from inside, a ray is in the box from its start to the first t_max (M1)") {
    CHECK(inside(Ray{.origin = {0, 0, 0}, .direction = {0, 0, -1}}, block, {0, 3}));
    CHECK(inside(Ray{.origin = {0, 1, 2}, .direction = {0, 1, 0}}, block, {0, 1}));
    CHECK(for_all([](Random& random) {
        const auto [box, line] = draw_chord(random);
        const Real share = random.between(Real(0.1), Real(0.9));
        return inside({.origin = at(line, share), .direction = line.direction}, box,
                      {0, 1 - share});
    }));
}

namespace {

/// A ray along a face of a box around 0, or along an edge, where it is on a third plane as well.
Verdict inside_along(const BoundingBox& box, glm::length_t face, Vec3 corner, glm::length_t along,
                     int sign, bool edge) {
    Ray ray{.origin = {0, 0, 0}, .direction = {0, 0, 0}};
    ray.direction[along] = Real(sign);
    ray.origin[along] = Real(-16 * sign);
    ray.origin[face] = corner[face];
    const glm::length_t third = 3 - face - along;
    if (edge) ray.origin[third] = corner[third];
    const Real half = box.max[along];
    return inside(ray, box, {16 - half, 16 + half});
}

/// Rays along the axes, whose two other coordinates are such a zero.
Verdict zeros_are_zero(Real zero) {
    const std::array cases = {
        inside(Ray{.origin = {0, 0, 5}, .direction = {zero, zero, -1}}, block, {2, 8}),
        inside(Ray{.origin = {-5, 1, 2}, .direction = {1, zero, zero}}, block, {4, 6}),
        inside(Ray{.origin = {1, -5, -3}, .direction = {zero, 1, zero}}, block, {3, 7}),
        inside(Ray{.origin = {-1, -5, 3}, .direction = {zero, 1, zero}}, block, {3, 7}),
        outside(Ray{.origin = {2, 0, 5}, .direction = {zero, zero, -1}}, block),
        outside(Ray{.origin = {-2, 0, 5}, .direction = {zero, zero, -1}}, block)};
    const auto wrong = std::ranges::find(cases, false, &Verdict::holds);
    return wrong == cases.end() ? Verdict{} : *wrong;
}

}  // namespace

TEST_CASE("a ray along a face or an edge is in the box, though 0 times infinity is NaN (M1)") {
    CHECK(for_all([](Random& random) {
        // Sizes in eighths, which need no rounding.
        const int width = 1 + random.below(64);
        const int height = 1 + random.below(64);
        const Vec3 half = Vec3(width, height, 1 + random.below(64)) / Real(8);
        const BoundingBox box{.min = -half, .max = half};
        const glm::length_t face = random.below(3);
        const glm::length_t along = (face + 1 + random.below(2)) % 3;
        const int sign = random.coin() ? 1 : -1;
        const Vec3 corner = random.coin() ? box.min : box.max;
        return inside_along(box, face, corner, along, sign, random.coin());
    }));
}

TEST_CASE("a coordinate of the direction may be 0, and -0 is 0 (M1, Williams et al.)", "[exact]") {
    CHECK(zeros_are_zero(Real(0)));
    CHECK(zeros_are_zero(-Real(0)));
    CHECK(for_all([](Random& random) {
        // Along an axis, in eighths: nothing is rounded.
        const Vec3 corner = random.point_in_eighths(3);
        const Vec3 size(random.eighths(1, 4), random.eighths(1, 4), random.eighths(1, 4));
        const Real zero = random.coin() ? Real(0) : -Real(0);
        const glm::length_t along = random.below(3);
        const Real t = random.eighths(1, 32);
        Ray ray{.origin = corner + Real(0.5) * size, .direction = Vec3(zero)};
        ray.origin[along] = corner[along] - t;
        ray.direction[along] = 1;
        return inside(ray, {.min = corner, .max = corner + size}, {t, t + size[along]});
    }));
}

TEST_CASE("a flat box is hit: max t_min = min t_max is no miss (M1)", "[exact]") {
    const BoundingBox sheet{.min = {-1, -2, 3}, .max = {1, 2, 3}};
    CHECK(inside(Ray{.origin = {0, 0, 5}, .direction = {0, 0, -1}}, sheet, {2, 2}));
    CHECK(inside(Ray{.origin = {3, 0, 0}, .direction = {-1, 0, 1}}, sheet, {3, 3}));
    CHECK(outside(Ray{.origin = {3, 3, 0}, .direction = {-1, 0, 1}}, sheet));
    CHECK(for_all([](Random& random) {
        auto [box, line] = draw_chord(random);
        const glm::length_t axis = random.below(3);
        const Vec3 point = draw_on_face(random, box, int(2 * axis));
        box.max[axis] = box.min[axis];
        Vec3 direction = random.direction();
        if (std::abs(direction[axis]) < Real(0.2)) direction[axis] = 1;
        return inside({.origin = point - Real(3) * direction, .direction = direction}, box, {3, 3});
    }));
}

TEST_CASE("only the part of the ray in the interval counts (contract)") {
    const Ray ray{.origin = {0, 0, 5}, .direction = {0, 0, -1}};
    CHECK(inside(ray, block, {3, 7}, Interval{.min = 3, .max = 7}));
    CHECK(inside(ray, block, {2, 4}, Interval{.min = 1, .max = 4}));
    CHECK(inside(ray, block, {4, 8}, Interval{.min = 4, .max = 9}));
    CHECK(outside(ray, block, Interval{.min = 0, .max = 1}));
    CHECK(outside(ray, block, Interval{.min = 9, .max = infinity}));
}

TEST_CASE("with a coordinate that is not a number, a ray is in no box (contract)") {
    CHECK(for_all([](Random& random) {
        const auto [box, line] = draw_chord(random);
        Ray ray{.origin = at(line, -1), .direction = line.direction};
        Vec3& part = random.coin() ? ray.origin : ray.direction;
        part[random.below(3)] = std::numeric_limits<Real>::quiet_NaN();
        return outside(ray, box);
    }));
}

TEST_CASE("a ray meets the near face of an oriented box, half a size from its center (M1)") {
    CHECK(hits(Ray{.origin = {0, 0, 0}, .direction = {0, 0, -1}}, upright, 2));
    CHECK(hits(Ray{.origin = {5, 0, -5}, .direction = {-1, 0, 0}}, upright, 4));
    CHECK(hits(Ray{.origin = {0, -6, -5}, .direction = {0, 2, 0}}, upright, 2));
    CHECK(hits(Ray{.origin = {Real(0.9), Real(1.9), 0}, .direction = {0, 0, -1}}, upright, 2));
    CHECK(misses(Ray{.origin = {Real(1.1), 0, 0}, .direction = {0, 0, -1}}, upright));
    CHECK(misses(Ray{.origin = {0, Real(2.1), 0}, .direction = {0, 0, -1}}, upright));
}

TEST_CASE("an oriented box turns with its basis (M1)") {
    // Its x axis is the scene's y, its y axis the scene's -x.
    OrientedBox rotated = upright;
    rotated.basis = {.x = {0, 1, 0}, .y = {-1, 0, 0}, .z = {0, 0, 1}};
    CHECK(hits(Ray{.origin = {Real(1.9), 0, 0}, .direction = {0, 0, -1}}, rotated, 2));
    CHECK(misses(Ray{.origin = {0, Real(1.1), 0}, .direction = {0, 0, -1}}, rotated));
    // Round z by the angle of 3, 4, 5: along (0.8, 0.6) it reaches to 1, along (-0.6, 0.8) to 2.
    const Real s = Real(0.6);
    const Real c = Real(0.8);
    rotated.basis = {.x = {c, s, 0}, .y = {-s, c, 0}, .z = {0, 0, 1}};
    CHECK(hits(Ray{.origin = {5 * c, 5 * s, -5}, .direction = {-c, -s, 0}}, rotated, 4));
    CHECK(hits(Ray{.origin = {-5 * s, 5 * c, -5}, .direction = {s, -c, 0}}, rotated, 3));
    const Vec3 near_corner = Real(0.9) * rotated.basis.x + Real(1.9) * rotated.basis.y;
    const Vec3 past_corner = Real(0.9) * rotated.basis.x + Real(2.1) * rotated.basis.y;
    CHECK(hits(Ray{.origin = near_corner, .direction = {0, 0, -1}}, rotated, 2));
    CHECK(misses(Ray{.origin = past_corner, .direction = {0, 0, -1}}, rotated));
}

TEST_CASE("rays aimed at a point of an oriented box meet it there (M1)") {
    CHECK(aimed_rays_hit(draw_box));
}

TEST_CASE("rays aimed past an oriented box miss (M1)") {
    CHECK(for_all([](Random& random) {
        const Sample<OrientedBox> sample = draw_box(random);
        Vec3 along = cross(sample.normal, random.direction());
        if (along == Vec3(0)) along = cross(sample.normal, Vec3(1, 2, 3));
        const Vec3 passed = sample.point + random.between(Real(0.01), 1) * sample.normal;
        return misses({.origin = passed - Real(4) * unit(along), .direction = along}, sample.shape);
    }));
}

TEST_CASE("from inside, an oriented box is met where the ray leaves it (M1)") {
    CHECK(hits(Ray{.origin = {0, 0, -5}, .direction = {0, 0, -1}}, upright, 3));
    CHECK(hits(Ray{.origin = {0, 1, -5}, .direction = {0, 1, 0}}, upright, 1));
    CHECK(for_all([](Random& random) {
        const Sample<OrientedBox> sample = draw_box(random);
        const auto& [x, y, z] = sample.shape.basis;
        const Vec3 p = random.point(Real(0.5)) * sample.shape.half_size;
        const Vec3 origin = sample.shape.center + p.x * x + p.y * y + p.z * z;
        return hits({.origin = origin, .direction = sample.point - origin}, sample.shape, 1);
    }));
}

TEST_CASE("an oriented box behind the eye is missed (erratum 8, M1)") {
    CHECK(misses(Ray{.origin = {0, 0, 0}, .direction = {0, 0, 1}}, upright));
    CHECK(nothing_behind_is_hit(draw_box));
}

TEST_CASE("a ray along a face, into an edge or past an edge that it touches meets the box (M1)",
          "[exact]") {
    CHECK(hits(Ray{.origin = {1, 0, 0}, .direction = {0, 0, -1}}, upright, 2));
    CHECK(hits(Ray{.origin = {0, -2, 0}, .direction = {0, 0, -1}}, upright, 2));
    CHECK(hits(Ray{.origin = {3, 0, 0}, .direction = {-1, 0, -1}}, upright, 2));
    CHECK(hits(Ray{.origin = {-1, 0, 0}, .direction = {1, 0, -1}}, upright, 2));
    CHECK(for_all([](Random& random) {
        const OrientedBox box = draw_box_in_eighths(random);
        const auto& [x, y, z] = box.basis;
        const Vec3 edge =
            box.center + box.half_size.x * x + random.eighths(-1, 1) * y + box.half_size.z * z;
        const std::array directions{-z, -x - z, x - z};  // along, into, past
        const Vec3 direction = directions[std::size_t(random.below(3))];
        const Real t = random.eighths(1, 32);
        return hits({.origin = edge - t * direction, .direction = direction}, box, t);
    }));
}

TEST_CASE("an oriented box is met however near it is (erratum 31, contract)", "[exact]") {
    const Real near = std::ldexp(Real(1), -20);
    CHECK(hits(Ray{.origin = {0, 0, near - 2}, .direction = {0, 0, -1}}, upright, near));
    CHECK(hits(Ray{.origin = {0, 0, 1}, .direction = {0, 0, -3 / near}}, upright, near));
    CHECK(for_all([near](Random& random) {
        const OrientedBox box = draw_box_in_eighths(random);
        const auto& [x, y, z] = box.basis;
        const Vec3 met = box.center + random.eighths(-1, 1) * x + box.half_size.z * z;
        const Real t = random.eighths(1, 32);
        return hits({.origin = met + t * z, .direction = -t / near * z}, box, near);
    }));
}

TEST_CASE("a ray that leaves a face does not meet it at once (PHY, t > 0)", "[exact]") {
    CHECK(misses(Ray{.origin = {0, 0, -2}, .direction = {0, 0, 1}}, upright));
    CHECK(hits(Ray{.origin = {0, 0, -2}, .direction = {0, 0, -1}}, upright, 6));
    CHECK(for_all([](Random& random) {
        const OrientedBox box = draw_box_in_eighths(random);
        const auto& [x, y, z] = box.basis;
        const Vec3 origin = box.center + random.eighths(-1, 1) * x / Real(2) + box.half_size.z * z;
        if (random.coin()) return misses({.origin = origin, .direction = z}, box);
        return hits({.origin = origin, .direction = -z}, box, 2 * box.half_size.z);
    }));
}

TEST_CASE("only faces strictly inside the interval are met (contract)", "[exact]") {
    const Ray ray{.origin = {0, 0, 0}, .direction = {0, 0, -1}};
    CHECK(hits(ray, upright, 8, Interval{.min = 3, .max = infinity}));
    CHECK(misses(ray, upright, Interval{.min = 3, .max = 7}));
    CHECK(misses(ray, upright, Interval{.min = 0, .max = 2}));
    CHECK(interval_is_kept(draw_box));
}

TEST_CASE("a box is the same box after everything has moved, turned and grown (HAI)") {
    CHECK(motion_changes_nothing(draw_box));
}

TEST_CASE("with a coordinate that is not a number, a ray misses an oriented box (contract)") {
    CHECK(nan_misses(draw_box));
}

TEST_CASE("the normal is that of the face, not of the largest coordinate (M1)") {
    CHECK(normal_is(upright, {1, Real(1.5), -5}, {1, 0, 0}));
    CHECK(normal_is(upright, {-1, Real(1.5), Real(-7.5)}, {-1, 0, 0}));
    CHECK(normal_is(upright, {Real(0.5), 2, Real(-7.5)}, {0, 1, 0}));
    CHECK(normal_is(upright, {Real(0.5), -2, -5}, {0, -1, 0}));
    CHECK(normal_is(upright, {0, 0, -8}, {0, 0, -1}));
    CHECK(normals_point_outward(draw_box));
}

TEST_CASE("a mesh that is moved: the ray is moved the other way (HAI, translate)") {
    const Ray seen =
        to_object_space({.origin = {1, 2, 8}, .direction = {0, 1, -1}}, {.translation = {1, 2, 3}});
    CHECK(gives("the origin, 1,2,8 with the mesh at 1,2,3", seen.origin, Vec3(0, 0, 5)));
    CHECK(gives("the direction, which moving leaves alone", seen.direction, Vec3(0, 1, -1)));
}

TEST_CASE("a mesh twice as large: the ray and its direction are halved (HAI, scale)") {
    const Ray seen = to_object_space({.origin = {2, 0, 8}, .direction = {0, 1, -1}}, {.scale = 2});
    CHECK(gives("the origin, 2,0,8 with the mesh scaled by 2", seen.origin, Vec3(1, 0, 4)));
    CHECK(gives("the direction, not made unit length", seen.direction,
                Vec3(0, Real(0.5), Real(-0.5))));
}

TEST_CASE("a mesh that is turned: the ray is turned the other way (HAI, rotate)") {
    // A quarter turn around z: the mesh's x axis is the scene's y.
    const Basis quarter{.x = {0, 1, 0}, .y = {-1, 0, 0}, .z = {0, 0, 1}};
    const Ray seen =
        to_object_space({.origin = {0, 5, 1}, .direction = {1, 0, 0}}, {.rotation = quarter});
    CHECK(gives("the origin, 0,5,1 on the turned x axis", seen.origin, Vec3(5, 0, 1)));
    CHECK(gives("the direction 1,0,0, against the turned y axis", seen.direction, Vec3(0, -1, 0)));
}

TEST_CASE("a mesh is scaled, then turned, then moved, and the ray all that backwards (HAI)") {
    const Basis quarter{.x = {0, 1, 0}, .y = {-1, 0, 0}, .z = {0, 0, 1}};
    const Transform placement{.rotation = quarter, .scale = 2, .translation = {1, 2, 3}};
    const Ray seen = to_object_space({.origin = {1, 12, 5}, .direction = {0, -4, 0}}, placement);
    CHECK(gives("the origin", seen.origin, Vec3(5, 0, 1)));
    CHECK(gives("the direction", seen.direction, Vec3(-2, 0, 0)));
}

TEST_CASE("every point of the ray keeps its t in the mesh's frame (M1, change of frame)") {
    CHECK(for_all([](Random& random) {
        const Transform placement = random_motion(random);
        const Ray expected{.origin = random.point(4), .direction = random.direction()};
        const Ray asked = transformed(expected, placement);
        const Ray got = to_object_space(asked, placement);
        return verdict(
            close(got.origin, expected.origin) && close(got.direction, expected.direction),
            "to_object_space(" + code(asked) + ",\n           " + code(placement) +
                ")\n  got:      " + code(got) + "\n  expected: " + code(expected));
    }));
}

TEST_CASE("a mesh's triangles have the vertices that they name, counted from 0 (CR §4.2)") {
    CHECK(meets(down_z, layers, {.t = 3, .triangle = 1, .weights = half_and_quarters}));
    CHECK(meets({.origin = {0, 0, 1}, .direction = {0, 0, -1}}, layers,
                {.t = 1, .triangle = 0, .weights = half_and_quarters}));
    const Mesh one{.vertices = {{0, 1, 0}, {-1, -1, 0}, {1, -1, 0}}, .triangles = {{0, 1, 2}}};
    CHECK(meets(down_z, one, {.t = 5, .triangle = 0, .weights = half_and_quarters}));
    CHECK(misses_mesh({.origin = {0, 2, 5}, .direction = {0, 0, -1}}, one));
}

TEST_CASE("the closest triangle is hit, for any order of the triangles (M1, CR §4.2)") {
    Mesh reversed = layers;
    std::swap(reversed.triangles[0], reversed.triangles[1]);
    CHECK(meets(down_z, reversed, {.t = 3, .triangle = 0, .weights = half_and_quarters}));
    const Ray up_z{.origin = {0, 0, -5}, .direction = {0, 0, 1}};
    CHECK(meets(up_z, layers, {.t = 5, .triangle = 0, .weights = half_and_quarters}));
    CHECK(meets(up_z, reversed, {.t = 5, .triangle = 1, .weights = half_and_quarters}));
    CHECK(for_all([](Random& random) {
        const Stack stack = draw_stack(random);
        const Real length = random.power_of_two();
        const Ray ray{.origin = stack.line.origin, .direction = length * stack.line.direction};
        if (stack.crossed.empty()) return misses_mesh(ray, stack.mesh);
        MeshHit expected = stack.crossed.front();
        expected.t /= length;
        return meets(ray, stack.mesh, expected);
    }));
}

TEST_CASE("the weights are those of the vertices in their order, and sum to 1 (CR §4.1, M1)") {
    const Mesh one{.vertices = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, .triangles = {{0, 1, 2}}};
    const auto above = [](Real x, Real y) {
        return Ray{.origin = {x, y, 5}, .direction = {0, 0, -1}};
    };
    const auto weights = [](Real a, Real b, Real c) {
        return MeshHit{.t = 5, .triangle = 0, .weights = {a, b, c}};
    };
    CHECK(meets(above(Real(0.5), Real(0.5)), one, weights(Real(0.75), Real(0.125), Real(0.125))));
    CHECK(meets(above(3, Real(0.5)), one, weights(Real(0.125), Real(0.75), Real(0.125))));
    CHECK(meets(above(Real(0.5), 3), one, weights(Real(0.125), Real(0.125), Real(0.75))));
    // The same triangle named from its second vertex on.
    Mesh rotated = one;
    rotated.triangles = {{1, 2, 0}};
    CHECK(meets(above(3, Real(0.5)), rotated, weights(Real(0.75), Real(0.125), Real(0.125))));
}

TEST_CASE("a ray through the mesh's box misses where no triangle is (CR §4.2)") {
    // Past an edge of the octahedron, well inside the box around it.
    const Ray past{.origin = {Real(0.7), Real(0.7), 5}, .direction = {0, 0, -1}};
    CHECK(misses_mesh(past, octahedron()));
    const Ray through{.origin = {Real(0.25), Real(0.25), 5}, .direction = {0, 0, -1}};
    CHECK(meets(through, octahedron(),
                {.t = Real(4.5), .triangle = 0, .weights = {Real(0.25), Real(0.25), Real(0.5)}}));
    CHECK(misses_mesh(through, Mesh{}));
}

TEST_CASE("from inside, a mesh is met from its inside (CR §4.2)") {
    const Ray out{.origin = {0, 0, 0}, .direction = {1, 1, 2}};
    CHECK(meets(out, octahedron(),
                {.t = Real(0.25), .triangle = 0, .weights = {Real(0.25), Real(0.25), Real(0.5)}}));
    const Ray behind{.origin = {0, 0, 5}, .direction = {0, 0, 1}};
    CHECK(misses_mesh(behind, octahedron()));
}

TEST_CASE("the vertices are where they are, not ten thousand times nearer (erratum 28, CR §4.2)") {
    // The listing makes it 0.0002 wide: a ray half a unit from its middle would miss.
    const Mesh one{.vertices = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}, .triangles = {{0, 1, 2}}};
    CHECK(meets({.origin = {0, Real(-0.5), 5}, .direction = {0, 0, -1}}, one,
                {.t = 5, .triangle = 0, .weights = {Real(0.375), Real(0.375), Real(0.25)}}));
}

TEST_CASE("a triangle is met however near it is (erratum 31, CR §4.2)", "[exact]") {
    const Real near = std::ldexp(Real(1), -20);  // the listing requires t > 0.001
    CHECK(meets({.origin = {0, 0, 2 + near}, .direction = {0, 0, -1}}, layers,
                {.t = near, .triangle = 1, .weights = half_and_quarters}));
    CHECK(meets({.origin = {0, 0, 5}, .direction = {0, 0, -3 / near}}, layers,
                {.t = near, .triangle = 1, .weights = half_and_quarters}));
    CHECK(for_all([near](Random& random) {
        const auto [mesh, line, crossed] = draw_stack(random);
        if (crossed.empty()) return misses_mesh(line, mesh);
        MeshHit first = crossed.front();
        const Real length = first.t / near;
        first.t = near;
        return meets({.origin = line.origin, .direction = length * line.direction}, mesh, first);
    }));
}

TEST_CASE("only triangles strictly inside the interval are met (contract)", "[exact]") {
    CHECK(meets(down_z, layers, {.t = 5, .triangle = 0, .weights = half_and_quarters},
                Interval{.min = 3, .max = infinity}));
    CHECK(misses_mesh(down_z, layers, Interval{.min = 3, .max = 5}));
    CHECK(misses_mesh(down_z, layers, Interval{.min = 0, .max = 3}));
    CHECK(for_all([](Random& random) {
        const auto [mesh, line, crossed] = draw_stack(random);
        const Interval interval{.min = Real(1 + 2 * random.below(7)),
                                .max = Real(1 + 2 * random.below(7))};
        const auto first = std::ranges::find_if(
            crossed, [&](const MeshHit& hit) { return interval.contains(hit.t); });
        if (first == crossed.end()) return misses_mesh(line, mesh, interval);
        return meets(line, mesh, *first, interval);
    }));
}

TEST_CASE("with a coordinate that is not a number, a ray misses a mesh (contract)") {
    CHECK(for_all([](Random& random) {
        auto [mesh, ray, crossed] = draw_stack(random);
        Vec3& part = random.coin() ? ray.origin : ray.direction;
        part[random.below(3)] = std::numeric_limits<Real>::quiet_NaN();
        return misses_mesh(ray, mesh);
    }));
}

namespace {

Verdict interpolates(const std::array<Vec3, 3>& normals, Vec3 weights, Vec3 expected) {
    const auto& [a, b, c] = normals;
    const std::string asked =
        "{" + code(a) + ", " + code(b) + ", " + code(c) + "}, " + code(weights);
    return verdict(close(interpolated_normal(normals, weights), expected),
                   "interpolated_normal(" + asked +
                       ")\n  got:      " + text(interpolated_normal(normals, weights)) +
                       "\n  expected: " + text(expected) + "\n  paste:    CHECK(interpolates(" +
                       asked + ", " + code(expected) + "));");
}

/// Three unit normals, at most 60° from a direction.
std::array<Vec3, 3> draw_normals(Random& random) {
    const Vec3 around = random.direction();
    std::array<Vec3, 3> normals;
    for (Vec3& normal : normals) {
        normal = random.direction();
        if (dot(normal, around) < 0) normal = -normal;
        normal = unit(normal + Real(0.6) * around);
    }
    return normals;
}

Vec3 draw_weights(Random& random) {
    const Real a = random.between(0, 1);
    const Real b = random.between(0, 1 - a);
    return {a, b, 1 - a - b};
}

}  // namespace

TEST_CASE("at a vertex, the normal is that of the vertex (CR §6)") {
    const std::array<Vec3, 3> axes = {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
    CHECK(interpolates(axes, {1, 0, 0}, {1, 0, 0}));
    CHECK(interpolates(axes, {0, 1, 0}, {0, 1, 0}));
    CHECK(interpolates(axes, {0, 0, 1}, {0, 0, 1}));
}

TEST_CASE("between vertices, the normal is between theirs, by the weights (CR §6)") {
    const std::array<Vec3, 3> axes = {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
    const Real third = Real(1) / 3;
    CHECK(interpolates(axes, {Real(0.5), Real(0.5), 0}, unit(Vec3(1, 1, 0))));
    CHECK(interpolates(axes, {third, third, third}, unit(Vec3(1, 1, 1))));
    // 1, 2, 2 over 5 is as long as 3 over 5.
    CHECK(interpolates(axes, {Real(0.2), Real(0.4), Real(0.4)}, Vec3(1, 2, 2) / Real(3)));
    CHECK(interpolates(axes, {Real(0.4), Real(0.4), Real(0.2)}, Vec3(2, 2, 1) / Real(3)));
    CHECK(for_all([](Random& random) {
        // On a sphere the normal is the point's own direction, from the center.
        const std::array<Vec3, 3> normals = draw_normals(random);
        const Vec3 weights = draw_weights(random);
        const auto& [a, b, c] = normals;
        return interpolates(normals, weights, unit(weights.x * a + weights.y * b + weights.z * c));
    }));
}

TEST_CASE("an interpolated normal has unit length (CR §6)") {
    CHECK(for_all([](Random& random) {
        const std::array<Vec3, 3> normals = draw_normals(random);
        const Vec3 weights = draw_weights(random);
        const Vec3 got = interpolated_normal(normals, weights);
        return verdict(close(length(got), 1), "interpolated_normal({" + code(normals[0]) + ", " +
                                                  code(normals[1]) + ", " + code(normals[2]) +
                                                  "}, " + code(weights) +
                                                  ")\n  got:      " + text(got) + ", of length " +
                                                  text(length(got)) + "\n  expected: of length 1");
    }));
}

TEST_CASE("a placed mesh is met where it has been moved to (HAI, CR §4.2)") {
    // The cube, twice as large, a quarter turn round z, at 0,0,-10: it reaches from -12 to -8.
    const Basis quarter{.x = {0, 1, 0}, .y = {-1, 0, 0}, .z = {0, 0, 1}};
    const MeshInstance instance{
        .model = model_of(cube()),
        .placement = {.rotation = quarter, .scale = 2, .translation = {0, 0, -10}}};
    CHECK(meets_placed({.origin = {1, Real(0.5), 0}, .direction = {0, 0, -1}}, instance, 8,
                       {1, Real(0.5), -8}));
    CHECK(meets_placed({.origin = {1, Real(0.5), 0}, .direction = {0, 0, -4}}, instance, 2,
                       {1, Real(0.5), -8}));
    CHECK(meets_placed({.origin = {1, Real(0.5), -10}, .direction = {0, 0, -1}}, instance, 2,
                       {1, Real(0.5), -12}));
}

TEST_CASE(
    "no ray at an edge or a vertex of a closed mesh is lost, for triangles one by one (contract)") {
    CHECK(none_lost(cube(), Asked::one_by_one));
    CHECK(none_lost(octahedron(), Asked::one_by_one));
}

TEST_CASE("no ray at an edge or a vertex of a closed mesh is lost, packed (contract)") {
    CHECK(none_lost(cube(), Asked::packed));
    CHECK(none_lost(ball(), Asked::packed));
}

TEST_CASE("a packed mesh gives the hits of its triangles one by one (CR §4.2)") {
    const auto packed = model_of(ball(), Asked::packed);
    const auto listed = model_of(ball(), Asked::one_by_one);
    CHECK(for_all([&](Random& random) {
        const Transform transform = random_motion(random);
        const Vec3 origin = Real(3) * random.direction();
        // At a point of the ball's inside, a tenth from its surface: not grazing.
        const Vec3 aim = random.between(0, Real(0.8)) * random.direction();
        const Ray ray = transformed(Ray{.origin = origin, .direction = aim - origin}, transform);
        const auto got = intersect(ray, MeshInstance{listed, transform}, {});
        const auto expected = intersect(ray, MeshInstance{packed, transform}, {});
        const bool same = got && expected && close(got->t, expected->t, 0);
        return verdict(same, "intersect(" + code(ray) + ", the ball, " + code(transform) +
                                 ")\n  got:      " + got_text(got) +
                                 "\n  expected: " + got_text(expected));
    }));
}

TEST_CASE("t compares with other shapes': the nearest of a mesh and a ball is seen (M1)") {
    for (const Real scale : {Real(0.25), Real(1), Real(4)}) {
        // A red cube that begins at z = -5, and a blue ball that begins at -4 or at -6.
        Scene scene;
        scene.ambient = everywhere;
        scene.meshes.push_back(
            {.shape = {.model = model_of(cube()),
                       .placement = {.scale = scale, .translation = {0, 0, -5 - scale}}},
             .material = {.color = red}});
        const Ray ray{.origin = {0, 0, 0}, .direction = {Real(0.01), Real(0.02), -2}};
        const std::string size = "a cube of size " + text(2 * scale) + ", a ball ";
        Scene before = scene;
        before.spheres.push_back({.shape = {.center = {0, 0, Real(-4.5)}, .radius = Real(0.5)},
                                  .material = {.color = blue}});
        CHECK(sees(size + "before it", before, ray, blue));
        Scene behind = scene;
        behind.spheres.push_back(
            {.shape = {.center = {0, 0, -16}, .radius = 10}, .material = {.color = blue}});
        CHECK(sees(size + "behind its face", behind, ray, red));
    }
}

namespace {

/// A mirror at z = -2, and behind the eye at 0 a red cube whose face is at z = 3.
Scene with_mirror() {
    Scene scene;
    scene.ambient = everywhere;
    scene.planes.push_back({.shape = {.point = {0, 0, -2}, .normal = {0, 0, 1}},
                            .material = {.color = blue, .mirror = 1}});
    scene.meshes.push_back(
        {.shape = {.model = model_of(cube()), .placement = {.translation = {0, 0, 4}}},
         .material = {.color = red}});
    return scene;
}

}  // namespace

TEST_CASE("a mirror shows a mesh (CR §5.1)") {
    CHECK(sees("a cube behind the eye, in a mirror", with_mirror(),
               Ray{.origin = {0, 0, 0}, .direction = {Real(0.05), Real(0.1), -1}}, red));
    CHECK(sees("a mirror beside the cube", with_mirror(),
               Ray{.origin = {0, 0, 0}, .direction = {Real(0.5), Real(0.1), -1}}, Color(0)));
}

TEST_CASE("a mesh casts a shadow, a box too, and neither on itself (CR §3.2)") {
    // White ground at y = -1, a light above it, and half-way a cube and a box, side by side.
    Scene scene;
    scene.ambient = Ambient{.ratio = Real(0.25)};
    scene.lights.push_back({.position = {0, 9, 0}, .brightness = Real(0.5)});
    scene.planes.push_back({.shape = {.point = {0, -1, 0}, .normal = {0, 1, 0}}});
    scene.meshes.push_back(
        {.shape = {.model = model_of(cube()), .placement = {.translation = {-2, 4, 0}}}});
    scene.boxes.push_back({.shape = {.center = {2, 4, 0}, .half_size = {1, 1, 1}}});
    const auto at_ground = [](Real x) {
        const Vec3 eye(x, 1, 6);
        return Ray{.origin = eye, .direction = Vec3(x, -1, Real(0.3)) - eye};
    };
    CHECK(sees("the ground below the cube", scene, at_ground(-4), Color(Real(0.25))));
    CHECK(sees("the ground below the box", scene, at_ground(4), Color(Real(0.25))));
    const Real cosine = 10 / length(Vec3(0, 10, Real(0.3)));
    CHECK(sees("the ground between them", scene, at_ground(0),
               Color(Real(0.25) + Real(0.5) * cosine)));
    // Their tops, four below the light and two aside.
    const Real top_cosine = 4 / length(Vec3(2, 4, 0));
    for (const Real x : {Real(-2), Real(2)})
        CHECK(sees("the top", scene, Ray{.origin = {x, 8, 0}, .direction = {0, -1, 0}},
                   Color(Real(0.25) + Real(0.5) * top_cosine)));
}

TEST_CASE("a mesh with normals is shaded by the interpolated one, without by its face's (CR §6)") {
    // A tent whose two sides lean by 45°: on the ridge the interpolated normal points up.
    Mesh tent{.vertices = {{-1, 0, 1}, {0, 1, 1}, {0, 1, -1}}, .triangles = {{0, 1, 2}}};
    const Real s = std::sqrt(Real(0.5));
    tent.normals = {{-s, s, 0}, {0, 1, 0}, {0, 1, 0}};
    const Basis quarter{.x = {0, 1, 0}, .y = {-1, 0, 0}, .z = {0, 0, 1}};
    const Transform placement{.rotation = quarter, .scale = 3, .translation = {1, 2, 3}};
    const Ray down =
        transformed(Ray{.origin = {Real(-0.5), 5, Real(0.5)}, .direction = {0, -1, 0}}, placement);
    const MeshInstance smooth{.model = model_of(tent), .placement = placement};
    const auto hit = intersect(down, smooth, {});
    REQUIRE(hit);
    // Half-way from the first vertex to the ridge.
    CHECK(gives("the interpolated normal", normal(smooth, *hit),
                rotated(unit(Vec3(-s, s, 0) + Vec3(0, 1, 0)), placement)));
    tent.normals.clear();
    const MeshInstance flat{.model = model_of(tent), .placement = placement};
    CHECK(gives("the face's normal", normal(flat, *hit), rotated(Vec3(-s, s, 0), placement)));
}

TEST_CASE("the picture of the stage (CR §4.2, §6)") {
    CHECK(picture_matches("step13_meshes", {.every = 4}));
}
