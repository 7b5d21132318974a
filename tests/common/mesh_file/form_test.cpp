// The parts, holes, crowded edges and turned triangles of meshes.

#include "common/mesh_file/half_edges.hpp"

#include "common/program/load_meshes.hpp"
#include "tests/common/mesh_file/reading.hpp"

#include "tests/kit/catch.hpp"

#include <limits>
#include <string>
#include <utility>
#include <vector>

using namespace rt;

namespace {

const Triangles tetrahedron = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

Triangles with_turned(Triangles triangles, std::size_t index) {
    std::swap(triangles[index][0], triangles[index][1]);
    return triangles;
}

void check(const MeshForm& found, const MeshForm& expected) {
    CHECK(found.parts == expected.parts);
    CHECK(found.holes == expected.holes);
    CHECK(found.longest_hole == expected.longest_hole);
    CHECK(found.crowded_edges == expected.crowded_edges);
    CHECK(found.turned == expected.turned);
    CHECK(found.one_sided == expected.one_sided);
}

/// A grid of quadrilaterals, each two triangles, without those of which `left_out` holds.
template <class LeftOut>
Triangles grid(std::uint32_t side, LeftOut left_out) {
    Triangles triangles;
    for (std::uint32_t row = 0; row < side; ++row)
        for (std::uint32_t column = 0; column < side; ++column) {
            if (left_out(row, column)) continue;
            const std::uint32_t a = row * (side + 1) + column;
            triangles.push_back({a, a + 1, a + side + 1});
            triangles.push_back({a + 1, a + side + 2, a + side + 1});
        }
    return triangles;
}

}  // namespace

TEST_CASE("the form of a closed mesh, and of one with a triangle turned over") {
    check(form_of(tetrahedron, 4), {.parts = 1});
    for (std::size_t i = 0; i < 4; ++i)
        check(form_of(with_turned(tetrahedron, i), 4), {.parts = 1, .turned = 1});
    // All turned inside out are consistent.
    Triangles inside_out = tetrahedron;
    for (auto& [a, b, c] : inside_out) std::swap(a, b);
    check(form_of(inside_out, 4), {.parts = 1});
}

TEST_CASE("the holes of a sheet are its border, and what is left out") {
    check(form_of(grid(6, [](auto, auto) { return false; }), 49),
          {.parts = 1, .holes = 1, .longest_hole = 24});
    const auto middle = [](auto row, auto column) {
        return row >= 2 && row < 4 && column >= 2 && column < 4;
    };
    check(form_of(grid(6, middle), 49), {.parts = 1, .holes = 2, .longest_hole = 24});
    // Two holes that touch in a corner have one way around both.
    const auto diagonal = [](auto row, auto column) {
        return (row == 2 && column == 2) || (row == 3 && column == 3);
    };
    check(form_of(grid(6, diagonal), 49), {.parts = 1, .holes = 2, .longest_hole = 24});
    // A third of all triangles turned over, here and there.
    Triangles mixed = grid(6, [](auto, auto) { return false; });
    for (std::size_t i = 0; i < mixed.size(); i += 3) std::swap(mixed[i][0], mixed[i][2]);
    check(form_of(mixed, 49), {.parts = 1, .holes = 1, .longest_hole = 24, .turned = 24});
}

TEST_CASE("two closed parts that touch in a vertex, and three triangles at an edge") {
    Triangles two = tetrahedron;
    for (const auto& [a, b, c] : tetrahedron) two.push_back({a + 3, b + 3, c + 3});
    check(form_of(two, 7), {.parts = 1});  // vertex 3 belongs to both
    for (auto& triangle : two)
        for (auto& corner : triangle) corner += corner >= 3 ? 2 : 0;
    check(form_of(two, 9), {.parts = 1});  // vertices in no triangle do not count
    check(form_of({{0, 1, 2}, {0, 1, 3}, {1, 0, 4}}, 5),
          {.parts = 1, .holes = 3, .longest_hole = 3, .crowded_edges = 1});
    check(form_of({{0, 1, 2}, {3, 4, 5}}, 6), {.parts = 2, .holes = 2, .longest_hole = 3});
}

TEST_CASE("a band with half turns has two sides if their number is even") {
    // Five quadrilaterals in a ring whose last is joined to the first the one way or the other.
    const auto band = [](bool half_turn) {
        Triangles triangles;
        for (std::uint32_t i = 0; i < 5; ++i) {
            const std::uint32_t a = 2 * i;
            const std::uint32_t b = a + 1;
            const std::uint32_t c = i < 4 ? a + 2 : half_turn ? 1 : 0;
            const std::uint32_t d = i < 4 ? a + 3 : half_turn ? 0 : 1;
            triangles.push_back({a, c, b});
            triangles.push_back({c, d, b});
        }
        return triangles;
    };
    check(form_of(band(false), 10), {.parts = 1, .holes = 2, .longest_hole = 5});
    check(form_of(with_turned(band(false), 4), 10),
          {.parts = 1, .holes = 2, .longest_hole = 5, .turned = 1});
    // Cut open once: the ten edges of its border, and both sides of the cut.
    for (std::size_t turned = 0; turned < 10; ++turned)
        check(form_of(with_turned(band(true), turned), 10),
              {.parts = 1, .holes = 1, .longest_hole = 12, .one_sided = 10});
    // Beside it, a tetrahedron of which one triangle is turned.
    Triangles two = band(true);
    for (const auto& [a, b, c] : with_turned(tetrahedron, 2))
        two.push_back({a + 10, b + 10, c + 10});
    check(form_of(two, 14),
          {.parts = 2, .holes = 1, .longest_hole = 12, .turned = 1, .one_sided = 10});
}

TEST_CASE("a triangle that is there twice is not turned over") {
    check(form_of({{0, 1, 2}, {1, 2, 0}}, 3), {.parts = 1, .holes = 2, .longest_hole = 3});
    check(form_of({{0, 1, 2}, {0, 2, 1}}, 3), {.parts = 1});
}

TEST_CASE("a scene's meshes: what --requirements prints, and the warning of a turned triangle") {
    const MeshFolder folder;
    const std::string vertices = "4 4 0\n10 0 0\n11 0 0\n10 1 0\n10 0 2\n";
    static_cast<void>(
        folder.write("right.off", "OFF\n" + vertices + "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n"));
    static_cast<void>(
        folder.write("turned.off", "OFF\n" + vertices + "3 0 2 1\n3 0 1 3\n3 2 1 3\n3 2 0 3\n"));
    static_cast<void>(
        folder.write("open.stl",
                     "solid\nfacet\nouter loop\nvertex 0 0 0\nvertex 3 0 0\nvertex 0 3 0\nendloop\n"
                     "endfacet\nendsolid\n"));
    const auto with = [&](std::vector<std::string> files, bool smooth) {
        Scene scene;
        for (const std::string& file : files)
            scene.mesh_requests.push_back(
                {.place = {(folder.path / "a.rt").string(), 2, 1}, .file = file, .smooth = smooth});
        return scene;
    };
    const std::string box = "; middle m 10.5,0.5,1, longest side e 2\n";
    CHECK(mesh_forms(with({}, true)).empty());
    CHECK_THROWS_WITH(mesh_forms(with({"absent.off"}, true)),
                      (folder.path / "absent.off").string() +
                          ": error: no such file (the mesh of " + (folder.path / "a.rt").string() +
                          ":2:1)");
    CHECK(mesh_forms(with({"right.off", "turned.off", "open.stl", "right.off"}, true)) ==
          "with the meshes\n  right.off: 4 triangles in 1 part, closed" + box +
              "  turned.off: 4 triangles in 1 part, closed, 1 triangle turned over" + box +
              "  open.stl: 1 triangle in 1 part, 1 hole of 3 edges; middle m 1.5,1.5,0, longest "
              "side e 3\n");
    static_cast<void>(folder.write(
        "moebius.off",
        "OFF\n6 6 0\n0 0 0\n0 0 1\n1 0 0\n1 0 1\n0 1 0\n0 1 1\n3 0 2 1\n3 2 3 1\n3 2 4 3\n3 4 5 3\n"
        "3 4 1 5\n3 1 0 5\n"));
    CHECK(mesh_forms(with({"moebius.off"}, true))
              .starts_with("with the meshes\n  moebius.off: 6 triangles in 1 part, 1 hole of 8 "
                           "edges, 6 triangles of a surface with only one side; "));
    // A square of 0.5 m at map coordinates: float has steps of 0.5 there, and moves by half of it.
    static_cast<void>(folder.write("map.off",
                                   "OFF\n4 1 0\n5000000 0 0\n5000000.5 0 0\n5000000.5 0.5 0\n"
                                   "5000000 0.5 0\n4 0 1 2 3\n"));
    CHECK(
        mesh_forms(with({"map.off"}, true))
            .ends_with("\n    at risk with --precision float: coordinates reach 5e+06, where float "
                       "moves points by up to 0.3, and the mesh is 0.5 large\n"));
    const auto warnings = [&](const std::string& file, bool smooth) {
        std::vector<std::string> all;
        Scene scene = with({file}, smooth);
        load_meshes(scene, [&](const std::string& text) { all.push_back(text); });
        return all;
    };
    CHECK(warnings("right.off", true).empty());
    CHECK(warnings("open.stl", true).empty());
    Scene beyond = with({"right.off"}, true);
    beyond.mesh_requests[0].placement.translation = Vec3(std::numeric_limits<Real>::max());
    beyond.mesh_requests[0].placement.scale = std::numeric_limits<Real>::max() / 4;
    CHECK_THROWS_WITH(
        load_meshes(beyond, nullptr),
        (folder.path / "a.rt").string() + ":2:1: error: the mesh reaches out of the range of " +
            (sizeof(Real) == 4 ? "float" : "double") + ": expected a smaller scale or position");
    CHECK(warnings("turned.off", false).empty());
    const auto one_sided = warnings("moebius.off", true);
    REQUIRE(one_sided.size() == 1);
    CHECK(one_sided[0].starts_with((folder.path / "moebius.off").string() +
                                   ": warning: 6 of 6 triangles belong to a surface with only one "
                                   "side, "));
    const auto found = warnings("turned.off", true);
    REQUIRE(found.size() == 1);
    CHECK(found[0].starts_with((folder.path / "turned.off").string() +
                               ": warning: 1 of 4 triangles is turned over, "));
    CHECK(found[0].ends_with("(the mesh of " + (folder.path / "a.rt").string() + ":2:1)"));
}
