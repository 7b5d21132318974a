// Meshes against CR §4.2, and interpolated normals against CR §6.
#include "steps/step13_meshes/meshes.hpp"
#include "common/geometry/triangle.hpp"

#include "tests/kit/shape_checks.hpp"
#include "tests/suites/step13_meshes/meshes.hpp"

#include <algorithm>
#include <array>

using namespace rt;

namespace {

std::string mesh_report(const Ray& ray, const Mesh& mesh, Interval interval,
                        const std::optional<MeshHit>& got, const std::optional<MeshHit>& expected) {
    const bool whole = interval.min == 0 && interval.max == infinity;
    const std::string last = whole ? "));" : ", " + code(interval) + "));";
    const std::string asked = code(ray) + ", " + mesh_code(mesh);
    const std::string paste = expected ? "hits_mesh(" + asked + ", {.t = " + code(expected->t) +
                                             ", .triangle = " + std::to_string(expected->triangle) +
                                             ", .weights = " + code(expected->weights) + "}"
                                       : "misses_mesh(" + asked;
    return "intersect(" + code(ray) + ",\n          " + mesh_code(mesh) + ",\n          " +
           code(interval) + ")\n  got:      " + got_text(got) +
           "\n  expected: " + got_text(expected) + "\n  paste:    CHECK(" + paste + last;
}

/// The ray first hits this triangle of the mesh there.
Verdict hits_mesh(const Ray& ray, const Mesh& mesh, const MeshHit& expected,
                  Interval interval = {}) {
    const auto got = intersect(ray, mesh, interval);
    const bool same = got && close(got->t, expected.t, 0) && got->triangle == expected.triangle &&
                      close(got->weights, expected.weights);
    return verdict(same, mesh_report(ray, mesh, interval, got, expected));
}

Verdict misses_mesh(const Ray& ray, const Mesh& mesh, Interval interval = {}) {
    const auto got = intersect(ray, mesh, interval);
    return verdict(!got, mesh_report(ray, mesh, interval, got, std::nullopt));
}

/// Two triangles one before the other, the closer one second, of five vertices one of which is
/// unused: a ray down the z axis has weights ½, ¼, ¼ in both.
const Mesh layers{
    .vertices = {{9, 9, 9}, {0, 1, 0}, {-1, -1, 0}, {1, -1, 0}, {0, 1, 2}, {-1, -1, 2}, {1, -1, 2}},
    .triangles = {{1, 2, 3}, {4, 5, 6}}};

const Ray down_z{.origin = {0, 0, 5}, .direction = {0, 0, -1}};
const Vec3 half_and_quarters{Real(0.5), Real(0.25), Real(0.25)};

/// One triangle of a long list is in the way, with its vertices behind others; the rest is aside.
Verdict is_found_in_list(int count, int place, int first_vertex) {
    Mesh mesh{.vertices = {{8, 1, 0}, {7, -1, 0}, {9, -1, 0}}};
    mesh.vertices.resize(std::size_t(first_vertex), Vec3(9, 9, 9));
    for (const Vec3& vertex : {Vec3(0, 1, 0), Vec3(-1, -1, 0), Vec3(1, -1, 0)})
        mesh.vertices.push_back(vertex);
    mesh.triangles.assign(std::size_t(count), {0, 1, 2});
    const auto first = std::uint32_t(first_vertex);
    mesh.triangles[std::size_t(place)] = {first, first + 1, first + 2};
    const auto got = intersect(down_z, mesh, {});
    const bool same = got && close(got->t, 5, 0) && got->triangle == std::uint32_t(place) &&
                      close(got->weights, half_and_quarters);
    return verdict(same, "intersect(" + code(down_z) + ", a mesh of " + std::to_string(count) +
                             " triangles), of which number " + std::to_string(place) +
                             " is in the way, with the vertices " + std::to_string(first) + ", " +
                             std::to_string(first + 1) + ", " + std::to_string(first + 2) +
                             "\n  got:      " + got_text(got) + "\n  expected: triangle " +
                             std::to_string(place) + " at t = 5");
}

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

}  // namespace

TEST_CASE("a mesh's triangles have the vertices that they name, counted from 0 (CR §4.2)",
          "[part meshes (intersect with a mesh)]") {
    CHECK(hits_mesh(down_z, layers, {.t = 3, .triangle = 1, .weights = half_and_quarters}));
    CHECK(hits_mesh({.origin = {0, 0, 1}, .direction = {0, 0, -1}}, layers,
                    {.t = 1, .triangle = 0, .weights = half_and_quarters}));
    const Mesh one{.vertices = {{0, 1, 0}, {-1, -1, 0}, {1, -1, 0}}, .triangles = {{0, 1, 2}}};
    CHECK(hits_mesh(down_z, one, {.t = 5, .triangle = 0, .weights = half_and_quarters}));
    CHECK(misses_mesh({.origin = {0, 2, 5}, .direction = {0, 0, -1}}, one));
    // The same in long lists.
    CHECK(is_found_in_list(300, 299, 3));
    CHECK(is_found_in_list(1, 0, 600));
    CHECK(is_found_in_list(70000, 69999, 66000));  // more than 2^16
    const auto in_any_list = [](Random& random) {
        const int count = 1 + random.below(4000);
        return is_found_in_list(count, random.below(count), 3 + random.below(1000));
    };
    CHECK(for_all(in_any_list, 20));
}

TEST_CASE("the closest triangle is hit, for any order of the triangles (M1, CR §4.2)") {
    Mesh reversed = layers;
    std::swap(reversed.triangles[0], reversed.triangles[1]);
    CHECK(hits_mesh(down_z, reversed, {.t = 3, .triangle = 0, .weights = half_and_quarters}));
    const Ray up_z{.origin = {0, 0, -5}, .direction = {0, 0, 1}};
    CHECK(hits_mesh(up_z, layers, {.t = 5, .triangle = 0, .weights = half_and_quarters}));
    CHECK(hits_mesh(up_z, reversed, {.t = 5, .triangle = 1, .weights = half_and_quarters}));
    CHECK(for_all([](Random& random) {
        const Stack stack = draw_stack(random);
        const Real length = random.power_of_two();
        const Ray ray{.origin = stack.line.origin, .direction = length * stack.line.direction};
        if (stack.crossed.empty()) return misses_mesh(ray, stack.mesh);
        MeshHit expected = stack.crossed.front();
        expected.t /= length;
        return hits_mesh(ray, stack.mesh, expected);
    }));
    // However close they are.
    const Real gap = std::ldexp(Real(1), sizeof(Real) == sizeof(float) ? -10 : -30);
    Mesh close_layers = layers;
    for (const int vertex : {1, 2, 3}) close_layers.vertices[std::size_t(vertex)].z = 2 - gap;
    CHECK(hits_mesh(down_z, close_layers, {.t = 3, .triangle = 1, .weights = half_and_quarters}));
    std::swap(close_layers.triangles[0], close_layers.triangles[1]);
    CHECK(hits_mesh(down_z, close_layers, {.t = 3, .triangle = 0, .weights = half_and_quarters}));
    // A triangle that has a vertex twice is not hit, and does not end the search. However the mesh
    // is moved, its area is exactly 0.
    Mesh with_flat = layers;
    with_flat.triangles.insert(with_flat.triangles.begin(), {4, 4, 5});
    CHECK(hits_mesh(down_z, with_flat, {.t = 3, .triangle = 2, .weights = half_and_quarters}));
    CHECK(hits_mesh(up_z, with_flat, {.t = 5, .triangle = 1, .weights = half_and_quarters}));
}

TEST_CASE("the weights are those of the vertices in their order, and sum to 1 (CR §4.1, M1)") {
    const Mesh one{.vertices = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, .triangles = {{0, 1, 2}}};
    const auto above = [](Real x, Real y) {
        return Ray{.origin = {x, y, 5}, .direction = {0, 0, -1}};
    };
    const auto weights = [](Real a, Real b, Real c) {
        return MeshHit{.t = 5, .triangle = 0, .weights = {a, b, c}};
    };
    CHECK(
        hits_mesh(above(Real(0.5), Real(0.5)), one, weights(Real(0.75), Real(0.125), Real(0.125))));
    CHECK(hits_mesh(above(3, Real(0.5)), one, weights(Real(0.125), Real(0.75), Real(0.125))));
    CHECK(hits_mesh(above(Real(0.5), 3), one, weights(Real(0.125), Real(0.125), Real(0.75))));
    // The same triangle named from its second vertex on.
    Mesh rotated = one;
    rotated.triangles = {{1, 2, 0}};
    CHECK(hits_mesh(above(3, Real(0.5)), rotated, weights(Real(0.75), Real(0.125), Real(0.125))));
}

TEST_CASE("a ray through the mesh's box misses where no triangle is (CR §4.2)") {
    // Past an edge of the octahedron, well inside the box around it.
    const Ray past{.origin = {Real(0.7), Real(0.7), 5}, .direction = {0, 0, -1}};
    CHECK(misses_mesh(past, octahedron()));
    const Ray through{.origin = {Real(0.25), Real(0.25), 5}, .direction = {0, 0, -1}};
    CHECK(
        hits_mesh(through, octahedron(),
                  {.t = Real(4.5), .triangle = 0, .weights = {Real(0.25), Real(0.25), Real(0.5)}}));
    CHECK(misses_mesh(through, Mesh{}));
}

TEST_CASE("a ray from inside a mesh hits its inside (CR §4.2)") {
    const Ray out{.origin = {0, 0, 0}, .direction = {1, 1, 2}};
    CHECK(hits_mesh(
        out, octahedron(),
        {.t = Real(0.25), .triangle = 0, .weights = {Real(0.25), Real(0.25), Real(0.5)}}));
    const Ray behind{.origin = {0, 0, 5}, .direction = {0, 0, 1}};
    CHECK(misses_mesh(behind, octahedron()));
}

TEST_CASE("hits of triangles whose vertices have large coordinates (erratum 28, CR §4.2)") {
    // The listing makes it 0.0002 wide: a ray half a unit from its middle would miss.
    const Mesh one{.vertices = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}, .triangles = {{0, 1, 2}}};
    CHECK(hits_mesh({.origin = {0, Real(-0.5), 5}, .direction = {0, 0, -1}}, one,
                    {.t = 5, .triangle = 0, .weights = {Real(0.375), Real(0.375), Real(0.25)}}));
}

TEST_CASE("very small triangles of a mesh are hit (contract)", "[exact]") {
    for (const int power : {-4, -12, -20}) {
        const Real size = std::ldexp(Real(1), power);
        Mesh small = layers;
        for (Vec3& vertex : small.vertices) vertex *= size;
        const Ray ray{.origin = size * down_z.origin, .direction = size * down_z.direction};
        CHECK(hits_mesh(ray, small, {.t = 3, .triangle = 1, .weights = half_and_quarters}));
    }
    CHECK(for_all([](Random& random) {
        auto [mesh, line, crossed] = draw_stack(random);
        const Real size = std::ldexp(Real(1), -4 - random.below(17));
        for (Vec3& vertex : mesh.vertices) vertex *= size;
        const Ray ray{.origin = size * line.origin, .direction = size * line.direction};
        return crossed.empty() ? misses_mesh(ray, mesh) : hits_mesh(ray, mesh, crossed.front());
    }));
}

TEST_CASE("a triangle of a mesh is hit at very small t (erratum 31, CR §4.2)", "[exact]") {
    const Real near = std::ldexp(Real(1), -20);  // the listing requires t > 0.001
    CHECK(hits_mesh({.origin = {0, 0, 2 + near}, .direction = {0, 0, -1}}, layers,
                    {.t = near, .triangle = 1, .weights = half_and_quarters}));
    CHECK(hits_mesh({.origin = {0, 0, 5}, .direction = {0, 0, -3 / near}}, layers,
                    {.t = near, .triangle = 1, .weights = half_and_quarters}));
    CHECK(for_all([near](Random& random) {
        const auto [mesh, line, crossed] = draw_stack(random);
        if (crossed.empty()) return misses_mesh(line, mesh);
        MeshHit first = crossed.front();
        const Real length = first.t / near;
        first.t = near;
        return hits_mesh({.origin = line.origin, .direction = length * line.direction}, mesh,
                         first);
    }));
}

TEST_CASE("only triangles strictly inside the interval are hit (contract)", "[exact]") {
    CHECK(hits_mesh(down_z, layers, {.t = 5, .triangle = 0, .weights = half_and_quarters},
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
        return hits_mesh(line, mesh, *first, interval);
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
    const bool is_near_a = random.below(8) == 0;
    const Real a =
        is_near_a ? 1 - std::ldexp(Real(1), -4 - random.below(12)) : random.between(0, 1);
    const Real b = random.between(0, 1 - a);
    return {a, b, 1 - a - b};
}

}  // namespace

TEST_CASE("at a vertex, the normal is that of the vertex (CR §6)",
          "[part normals (interpolated_normal)]") {
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
    // Far apart, their mean is short: (1, 2, 0) / 5.
    CHECK(interpolates({Vec3(1, 0, 0), Vec3(Real(-0.6), Real(0.8), 0), Vec3(0, 0, 1)},
                       {Real(0.5), Real(0.5), 0}, unit(Vec3(1, 2, 0))));
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
