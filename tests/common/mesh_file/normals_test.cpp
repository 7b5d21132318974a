// Vertex normals, and the sides of triangles: doubled faces, creases, faces against their normals.

#include "common/geometry/mesh_normals.hpp"
#include "tests/common/mesh_file/reading.hpp"

#include "tests/kit/catch.hpp"

#include <cmath>
#include <string>
#include <vector>

using namespace rt;

namespace {

/// A wave z = sin x / 2 over a grid, each quadrilateral as two triangles.
Mesh wave(int side) {
    Mesh mesh;
    for (int row = 0; row <= side; ++row)
        for (int column = 0; column <= side; ++column) {
            const auto x = Real(6 * column) / Real(side);
            mesh.vertices.emplace_back(x, Real(6 * row) / Real(side), std::sin(x) / 2);
        }
    const auto at = [side](int row, int column) {
        return std::uint32_t(row * (side + 1) + column);
    };
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column) {
            mesh.triangles.push_back({at(row, column), at(row, column + 1), at(row + 1, column)});
            mesh.triangles.push_back(
                {at(row, column + 1), at(row + 1, column + 1), at(row + 1, column)});
        }
    return mesh;
}

Vec3 face_normal(const Mesh& mesh, const std::array<std::uint32_t, 3>& corners) {
    const Vec3 a = mesh.vertices[corners[0]];
    const Vec3 side = cross(mesh.vertices[corners[1]] - a, mesh.vertices[corners[2]] - a);
    return side / length(side);
}

/// A tube of n facets around the z axis, open at both ends.
Mesh tube(int n) {
    Mesh mesh;
    for (int i = 0; i < n; ++i) {
        const double turn = 2 * 3.14159265358979 * i / n;
        for (const Real z : {Real(0), Real(1)})
            mesh.vertices.emplace_back(Real(std::cos(turn)), Real(std::sin(turn)), z);
    }
    const auto count = std::uint32_t(2 * n);
    for (std::uint32_t i = 0; i < count; i += 2) {
        mesh.triangles.push_back({i, (i + 2) % count, i + 1});
        mesh.triangles.push_back({(i + 2) % count, (i + 3) % count, i + 1});
    }
    return mesh;
}

}  // namespace

TEST_CASE("smooth normals of a sheet whose faces are there twice are those of the sheet") {
    const Mesh single = smoothed(wave(12));
    Mesh mesh = wave(12);
    const std::size_t front = mesh.triangles.size();
    for (std::size_t i = 0; i < front; ++i) {
        const auto [a, b, c] = mesh.triangles[i];
        mesh.triangles.push_back(i % 2 == 0 ? std::array{b, a, c} : std::array{c, b, a});
    }
    add_smooth_normals(mesh);
    CHECK(mesh.vertices.size() == 2 * single.vertices.size());
    REQUIRE(mesh.normals.size() == mesh.vertices.size());
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Real sign = i < front ? Real(1) : Real(-1);
        for (const std::uint32_t corner : mesh.triangles[i]) {
            // The vertex of the sheet at this place.
            const auto same = std::ranges::find(single.vertices, mesh.vertices[corner]);
            const Vec3 expected =
                sign * single.normals[std::size_t(same - single.vertices.begin())];
            CHECK(length(mesh.normals[corner] - expected) <= 16 * unit_roundoff);
        }
    }
}

TEST_CASE("smooth normals of a sheet whose back is cut along the other diagonals are its own") {
    Mesh mesh = wave(12);
    for (Vec3& vertex : mesh.vertices) vertex.z += std::sin(5 * vertex.x * vertex.y) / 1000;
    const std::size_t front = mesh.triangles.size();
    for (std::size_t i = 0; i < front; i += 2) {
        const auto [a, b, c] = mesh.triangles[i];  // of the quadrilateral a, b, d, c
        const std::uint32_t d = mesh.triangles[i + 1][1];
        mesh.triangles.push_back({a, c, d});
        mesh.triangles.push_back({a, d, b});
    }
    add_smooth_normals(mesh);
    for (const auto& triangle : mesh.triangles)
        for (const std::uint32_t corner : triangle)
            CHECK(dot(mesh.normals[corner], face_normal(mesh, triangle)) > Real(0.9));
}

TEST_CASE("a face that is there twice in front and once behind has three sides in front") {
    Mesh mesh = wave(4);
    const auto once = mesh.triangles;
    for (const auto& [a, b, c] : once) {
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({a, c, b});
    }
    add_smooth_normals(mesh);
    turn_to_normals(mesh);
    for (const auto& triangle : mesh.triangles) CHECK(face_normal(mesh, triangle).z > 0);
}

TEST_CASE("smooth normals look to the side of each face that meets them, however they cancel") {
    // Three walls at 120 degrees around one edge; and a fold that opens by an angle of 1e-9.
    const Real half = Real(0.5);
    const Real height = std::sqrt(Real(3)) / 2;
    const Mesh walls = smoothed(
        {.vertices = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-half, height, 0}, {-half, -height, 0}},
         .triangles = {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}});
    const Mesh fold = smoothed({.vertices = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 0, Real(1e-9)}},
                                .triangles = {{0, 2, 1}, {0, 1, 3}}});
    for (const Mesh& mesh : {walls, fold}) {
        for (const auto& triangle : mesh.triangles)
            for (const std::uint32_t corner : triangle) {
                CHECK(std::abs(length(mesh.normals[corner]) - 1) <= 4 * unit_roundoff);
                CHECK(dot(mesh.normals[corner], face_normal(mesh, triangle)) >= 0);
            }
    }
    // A sharp ridge of 0.2 is no fold: its vertices stay, with a normal between both sides.
    const Mesh ridge =
        smoothed({.vertices = {{0, 0, 0}, {0, 1, 0}, {-Real(0.1), 0, -1}, {Real(0.1), 0, -1}},
                  .triangles = {{0, 1, 2}, {0, 3, 1}}});
    CHECK(ridge.vertices.size() == 4);
    CHECK(length(ridge.normals[1] - Vec3(0, 0, 1)) <= Real(1e-4));
}

TEST_CASE("STL: facets join at flat edges, and edges of more than 40 degrees stay sharp") {
    // The normals of neighboring facets of a regular tube of n differ by 360/n degrees.
    for (const int n : {10, 12, 24}) {  // 36, 30 and 15 degrees
        const Mesh mesh = mesh_of("a.stl", as_stl(tube(n)));
        CHECK(mesh.vertices.size() == std::size_t(2 * n));
        REQUIRE(mesh.normals.size() == mesh.vertices.size());
        for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
            const Vec3 outwards(mesh.vertices[i].x, mesh.vertices[i].y, 0);
            CHECK(length(mesh.normals[i] - outwards) <= Real(1e-5));
        }
    }
    for (const int n : {3, 4, 8}) {  // 120, 90 and 45 degrees
        const Mesh mesh = mesh_of("a.stl", as_stl(tube(n)));
        CHECK(mesh.vertices.size() == std::size_t(4 * n));
        for (const auto& triangle : mesh.triangles)
            for (const std::uint32_t corner : triangle)
                CHECK(length(mesh.normals[corner] - face_normal(mesh, triangle)) <= Real(1e-5));
    }
}

TEST_CASE("STL: a facet that is turned over is turned back, and smooth as its neighbors are") {
    Mesh turned = tube(24);
    std::swap(turned.triangles[5][0], turned.triangles[5][1]);
    std::swap(turned.triangles[20][1], turned.triangles[20][2]);
    const MeshFolder folder;
    const std::string file = folder.write("a.stl", as_stl(turned));
    for (const bool smooth : {true, false}) {
        const Mesh mesh = load_mesh(
            file, [](const std::string& text) { FAIL_CHECK(text); }, smooth);
        CHECK(mesh.triangles.size() == 48);
        CHECK(mesh.vertices.size() == 48);
        REQUIRE(mesh.normals.size() == (smooth ? 48 : 0));
        for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
            const Vec3 outwards(mesh.vertices[i].x, mesh.vertices[i].y, 0);
            CHECK(length(mesh.normals[i] - outwards) <= Real(1e-5));
        }
    }
}

TEST_CASE("OBJ: faces are flat if the file switches smoothing off for all of them") {
    const std::string v = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
    const auto faces = [](const std::string& s) { return s + "f 1 3 2\nf 1 2 4\n"; };
    for (const std::string off : {"s off\n", "s 0\n", "s 1\ns off # flat\n"}) {
        const Mesh mesh = mesh_of("a.obj", v + faces(off));
        CHECK(mesh.vertices.size() == 6);
        REQUIRE(mesh.normals.size() == 6);
        for (const auto& triangle : mesh.triangles)
            for (const std::uint32_t corner : triangle)
                CHECK(mesh.normals[corner] == face_normal(mesh, triangle));
    }
    for (const std::string on : {"", "s 1\n", "s on\n", "s off\nf 1 4 3\ns 2\n"})
        CHECK(mesh_of("a.obj", v + faces(on)).normals.empty());
    // The file's own normals come first.
    const Mesh own =
        mesh_of("a.obj", v + "vn 0 0.6 0.8\ns off\nf 1//1 2//1 3//1\nf 1//1 2//1 4//1");
    REQUIRE(own.normals.size() == 4);
    CHECK(length(own.normals[0] - Vec3(0, Real(0.6), Real(0.8))) <= 4 * unit_roundoff);
}

TEST_CASE("normals that flat shading does not use are not warned of") {
    const MeshFolder folder;
    const std::string file = folder.write(
        "a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 0\nf 1//1 2//1 3//1\nf 1//1 2//1 3//9\n");
    std::vector<std::string> warnings;
    const auto warn = [&](const std::string& text) { warnings.push_back(text); };
    CHECK(load_mesh(file, warn, false).normals.empty());
    CHECK(warnings.empty());
    CHECK(load_mesh(file, warn, true).normals.size() == 3);
    CHECK(warnings.size() == 2);
}

TEST_CASE("corners that are clockwise, seen from the side of the file's normals, are turned") {
    const std::string obj =
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvn 0 0 1\nvn 0 0.6 0.8\n"
        "f 1//1 3//2 2//1\nf 1//1 3//2 4//1\n";  // the first is clockwise
    const Mesh mesh = mesh_of("a.obj", obj);
    REQUIRE(mesh.normals.size() == 4);
    for (const auto& triangle : mesh.triangles) CHECK(face_normal(mesh, triangle) == Vec3(0, 0, 1));
    CHECK(length(mesh.normals[2] - Vec3(0, Real(0.6), Real(0.8))) <= 4 * unit_roundoff);
}

TEST_CASE("coordinates far from the origin keep their digits in double, and float is warned of") {
    const std::string x[] = {"448250.013", "448250.713"};
    const std::string y[] = {"5411932.021", "5411932.721"};
    std::string off = "OFF\n4 2 0\n";
    std::string obj;
    std::string ply =
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\n"
        "property double y\nproperty double z\nelement face 2\n"
        "property list uchar int vertex_indices\nend_header\n";
    std::string stl = "solid\n";
    std::vector<std::string> points;
    for (const int i : {0, 1, 3, 2}) points.push_back(x[i % 2] + " " + y[i / 2] + " 0");
    for (const std::string& point : points) {
        off += point + "\n";
        ply += point + "\n";
        obj += "v " + point + "\n";
    }
    for (const auto& triangle : {std::array{0, 1, 2}, std::array{0, 2, 3}}) {
        stl += "facet normal 0 0 1\nouter loop\n";
        for (const int i : triangle) stl += "vertex " + points[std::size_t(i)] + "\n";
        stl += "endloop\nendfacet\n";
    }
    const std::string faces = "3 0 1 2\n3 0 2 3\n";
    const MeshFolder folder;
    for (const std::string& file :
         {folder.write("a.off", off + faces), folder.write("a.ply", ply + faces),
          folder.write("a.obj", obj + "f 1 2 3\nf 1 3 4\n"),
          folder.write("a.stl", stl + "endsolid\n")}) {
        INFO(file);
        std::vector<std::string> warnings;
        const Mesh mesh =
            load_mesh(file, [&](const std::string& text) { warnings.push_back(text); });
        REQUIRE(mesh.vertices.size() == 4);
        CHECK(mesh.vertices[2] == Vec3(Real(448250.713), Real(5411932.721), 0));
        if (sizeof(Real) == sizeof(float)) {
            // Half of the distance of 0.5 between two floats there; the square has sides of 0.7.
            REQUIRE(warnings.size() == 1);
            CHECK(warnings[0] == file +
                                     ": warning: coordinates reach 5.41e+06, where float moves "
                                     "points by up to 0.32, and the mesh is 0.7 large; try "
                                     "--precision double");
        } else {
            CHECK(warnings.empty());
        }
    }
    // All numbers are floats, with steps of 0.5 there: the file has lost digits already.
    const std::string coarse = "5411932 0 0\n5411932.5 0 0\n5411932 0.5 0\n3 0 1 2\n";
    std::vector<std::string> warnings;
    const std::string file = folder.write("coarse.off", "OFF\n3 1 0\n" + coarse);
    static_cast<void>(
        load_mesh(file, [&](const std::string& warning) { warnings.push_back(warning); }));
    REQUIRE(warnings.size() == 1);
    CHECK(warnings[0] == file +
                             ": warning: all coordinates are floats, which have steps of 0.5 here, "
                             "and the mesh is 0.5 large: it may have lost its shape before it was "
                             "written");
    // Whole numbers are floats, too, and exact. Of float itself there is a warning as above.
    warnings.clear();
    static_cast<void>(load_mesh(
        folder.write("fine.off", "OFF\n3 1 0\n5411932 0 0\n5411934 0 0\n5411932 2 0\n3 0 1 2\n"),
        [&](const std::string& warning) { warnings.push_back(warning); }));
    CHECK(warnings.size() == (sizeof(Real) == sizeof(float) ? 1 : 0));
    // Near the origin, both precisions have the same mesh.
    const Mesh near = mesh_of("a.off", "OFF\n3 1 0\n0.1 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    CHECK(near.vertices[0].x == Real(0.1F));
}
