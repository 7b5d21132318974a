// Placed meshes alone and in scenes, against HAI (transforms) and CR §4.2 and §6.
#include "steps/step13_meshes/mesh_instance.hpp"
#include "steps/step13_meshes/meshes.hpp"

#include "common/geometry/bounds.hpp"
#include "common/render/closest_hit.hpp"
#include "common/render/stage.hpp"

#include "tests/kit/light.hpp"
#include "tests/kit/picture.hpp"
#include "tests/kit/shape_checks.hpp"
#include "tests/suites/step13_meshes/meshes.hpp"

#include <algorithm>
#include <map>

using namespace rt;

namespace {

/// From (-1, -1, -1) to (1, 1, 1): twelve triangles, few enough to be tested one by one.
Mesh cube() {
    Mesh mesh;
    for (int i = 0; i < 8; ++i)
        mesh.vertices.emplace_back((i & 1) * 2 - 1, (i & 2) - 1, (i & 4) / 2 - 1);
    mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return mesh;
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

/// The nearest triangle of a placed mesh is hit at t, at this point of the scene.
Verdict hits_placed(const Ray& ray, const MeshInstance& instance, Real t, Vec3 point) {
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
    Verdict lost = for_all(
        [model](Random& random) {
            const Ray shot = draw_shot(random, model->mesh);
            const MeshInstance instance{.model = model, .placement = random_motion(random)};
            return hits_placed(transformed(shot, instance.placement), instance, 1,
                               transformed(at(shot, 1), instance.placement));
        },
        2000);
    if (!lost)
        lost.sentence +=
            "\n  Call stage 5's intersect for each triangle: at an edge that two of them "
            "share, it hits one of them at least.";
    return lost;
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

TEST_CASE("a placed mesh is hit where it has been moved to (HAI, CR §4.2)", "[part together]") {
    // The cube, twice as large, a quarter turn round z, at 0,0,-10: it reaches from -12 to -8.
    const Basis quarter{.x = {0, 1, 0}, .y = {-1, 0, 0}, .z = {0, 0, 1}};
    const MeshInstance instance{
        .model = model_of(cube()),
        .placement = {.rotation = quarter, .scale = 2, .translation = {0, 0, -10}}};
    CHECK(hits_placed({.origin = {1, Real(0.5), 0}, .direction = {0, 0, -1}}, instance, 8,
                      {1, Real(0.5), -8}));
    CHECK(hits_placed({.origin = {1, Real(0.5), 0}, .direction = {0, 0, -4}}, instance, 2,
                      {1, Real(0.5), -8}));
    CHECK(hits_placed({.origin = {1, Real(0.5), -10}, .direction = {0, 0, -1}}, instance, 2,
                      {1, Real(0.5), -12}));
}

TEST_CASE("rays to edges and vertices of a closed mesh hit, for triangles one by one (contract)") {
    CHECK(none_lost(cube(), Asked::one_by_one));
    CHECK(none_lost(octahedron(), Asked::one_by_one));
}

TEST_CASE("rays to edges and vertices of a closed mesh hit, packed (contract)") {
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

TEST_CASE("the shadows of a mesh and of a box, on others and on themselves (CR §3.2)") {
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
    CHECK(picture_matches("step13_meshes", {.every = 8}));
}
