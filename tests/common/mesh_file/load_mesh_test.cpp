// Meshes as they are read from OFF, OBJ, PLY and STL.

#include "common/geometry/mesh_normals.hpp"
#include "tests/common/mesh_file/reading.hpp"

#include "tests/kit/catch.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

using namespace rt;
using namespace std::string_literals;

namespace {

const std::string cube_off =
    "OFF\n8 6 12\n-1 -1 -1\n1 -1 -1\n1 1 -1\n-1 1 -1\n-1 -1 1\n1 -1 1\n1 1 1\n-1 1 1\n"
    "4 3 2 1 0\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n";

/// The triangles by their corners, each from its smallest, in order: a mesh whatever its numbering.
std::vector<std::array<std::array<Real, 3>, 3>> shape(const Mesh& mesh) {
    std::vector<std::array<std::array<Real, 3>, 3>> triangles;
    for (const auto& corners : mesh.triangles) {
        std::array<std::array<Real, 3>, 3> triangle;
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3 v = mesh.vertices[corners[i]];
            triangle[i] = {v.x, v.y, v.z};
        }
        std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()),
                    triangle.end());
        triangles.push_back(triangle);
    }
    std::sort(triangles.begin(), triangles.end());
    return triangles;
}

template <class Number>
std::string bytes(Number number, std::endian order) {
    std::string text(sizeof(number), '\0');
    std::memcpy(text.data(), &number, sizeof(number));
    if (order != std::endian::native) std::reverse(text.begin(), text.end());
    return text;
}

std::string as_obj(const Mesh& mesh) {
    std::string text = "# a cube\nmtllib /dev/zero\no cube\n";
    for (const Vec3& v : mesh.vertices) {
        text += "v " + std::to_string(v.x) + " " + std::to_string(v.y) + " " + std::to_string(v.z) +
                "\nvt 0 0\n";
    }
    for (const auto& t : mesh.triangles) {
        text += "usemtl x\nf " + std::to_string(t[0] + 1) + "/1 " + std::to_string(t[1] + 1) +
                " -" + std::to_string(mesh.vertices.size() - t[2]) + "\r\n";
    }
    return text;
}

/// With parts that a reader must skip: a color, a number per face, an element after the faces.
std::string as_binary_ply(const Mesh& mesh, std::endian order) {
    std::string text = std::string("ply\nformat binary_") +
                       (order == std::endian::little ? "little" : "big") +
                       "_endian 1.0\nelement vertex " + std::to_string(mesh.vertices.size()) +
                       "\nproperty float x\nproperty double y\nproperty float32 z\nproperty double "
                       "red\nelement face " +
                       std::to_string(mesh.triangles.size()) +
                       "\nproperty list uchar ushort vertex_index\nproperty short flag\n"
                       "element edge 1\nproperty list uchar int of\ncomment the end\nend_header\n";
    for (const Vec3& v : mesh.vertices) {
        text += bytes(float(v.x), order) + bytes(double(v.y), order) + bytes(float(v.z), order) +
                bytes(0.5, order);
    }
    for (const auto& t : mesh.triangles) {
        text += '\3';
        for (const std::uint32_t corner : t)
            text += bytes(static_cast<std::uint16_t>(corner), order);
        text += bytes(std::int16_t(7), order);
    }
    return text + "\1abcd";
}

std::string as_binary_stl(const Mesh& mesh) {
    std::string text = "solid, though it is binary";
    text.resize(80, ' ');
    text += bytes(static_cast<std::uint32_t>(mesh.triangles.size()), std::endian::little);
    for (const auto& t : mesh.triangles) {
        text += std::string(12, '\xff');  // a normal of NaN
        for (const std::uint32_t corner : t) {
            for (int i = 0; i < 3; ++i) {
                text += bytes(float(mesh.vertices[corner][i]), std::endian::little);
            }
        }
        text += "\0\0"s;
    }
    return text;
}

}  // namespace

TEST_CASE("a cube is the same mesh in every format") {
    const Mesh cube = mesh_of("cube.off", cube_off);
    const Topology whole = topology(cube);
    CHECK(whole.vertices == 8);
    CHECK(whole.triangles == 12);
    CHECK(whole.euler() == 2);
    CHECK(whole.open_edges + whole.shared_edges == 0);
    double volume = 0;
    for (const auto& t : cube.triangles) {
        const auto& v = cube.vertices;
        volume += double(glm::dot(v[t[0]], glm::cross(v[t[1]], v[t[2]]))) / 6;
    }
    CHECK(std::abs(volume - 8) < 1e-14);  // positive: its triangles turn outwards

    CHECK(shape(mesh_of("cube.obj", as_obj(cube))) == shape(cube));
    CHECK(shape(mesh_of("cube.PLY", as_binary_ply(cube, std::endian::little))) == shape(cube));
    CHECK(shape(mesh_of("cube.ply", as_binary_ply(cube, std::endian::big))) == shape(cube));
    CHECK(shape(mesh_of("cube.stl", as_stl(cube))) == shape(cube));
    CHECK(shape(mesh_of("cube.stl", as_binary_stl(cube))) == shape(cube));
    // Corners in the same place are one vertex of each face: the edges stay sharp.
    CHECK(topology(mesh_of("cube.stl", as_binary_stl(cube))).vertices == 24);
    CHECK(shape(load_mesh(RAYSTEPS_ROOT "/scenes/meshes/cube.off")).size() == 12);
}

TEST_CASE("a text whose lines end in CR alone is read like any other") {
    const Mesh cube = mesh_of("cube.off", cube_off);
    const auto with_cr = [](std::string text) {
        std::ranges::replace(text, '\n', '\r');
        return text;
    };
    const std::string triangle = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    CHECK(shape(mesh_of("cube.off", with_cr(cube_off))) == shape(cube));
    CHECK(mesh_of("a.obj", with_cr("v 0 0 0\nv 1 0 0\n# here\nv 0 1 0\nf 1 2 3")).triangles ==
          mesh_of("a.off", "OFF\n3 1 0\n" + triangle).triangles);
    CHECK(mesh_of("a.ply", with_cr(ply_header(3, 1) + triangle)).triangles.size() == 1);
    CHECK(mesh_of("a.stl", with_cr("solid a\n" + facet + "endsolid\n")).triangles.size() == 1);
}

TEST_CASE("OBJ: a comment may follow on any line; STL: keywords in upper case") {
    const Mesh mesh = mesh_of("a.obj", "v 0 0 0 # a\nv 1 0 0\nv 0 1 0\n# b\nf 1 2 3 # c\n");
    CHECK(mesh.triangles == std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}});
    CHECK(mesh_of("a.stl",
                  "SOLID A\nFACET NORMAL 0 0 1\nOUTER LOOP\nVERTEX 0 0 0\nVERTEX 1 0 0\n"
                  "VERTEX 0 1 0\nENDLOOP\nENDFACET\nENDSOLID\n")
              .triangles.size() == 1);
}

TEST_CASE("OBJ: a line that ends in a backslash goes on in the next one, but no comment does") {
    const Mesh mesh = mesh_of("a.obj",
                              "# C:\\meshes\\\nv 0 0 0\nv 1 \\\n0\\ \r\n 0\nv 0 1 0 # a \\\n"
                              "f 1 \\\n  2 3\n");
    CHECK(mesh.vertices == std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    CHECK(mesh.triangles == std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}});
}

TEST_CASE("OFF: comments, blank lines, counts beside the keyword, colors") {
    const std::string vertices = "0 0 0\n\n# one more\n1 0 0 # here\n0 1 0\n";
    for (const std::string& text :
         {"OFF\n3 1 0\n" + vertices + "3 0 1 2\n", "OFF\n3 1\n" + vertices + "3 0 1 2",
          "OFF 3 1 0\n" + vertices + "3 0 1 2 255 0 0\n",
          "OFF 3 1 0\n" + vertices + "+3 +0 0000000001\t2\r\n",
          "# first\n\nOFF # second\n# third\n3 2 0\n" + vertices + "3 0 1 2 0.5 0.5 0.5 1\n2 0 1\n",
          "COFF\r\n3 1 3\r\n0 0 0 9 9 9 255\r\n1 0 0 9 9 9 255\r\n0 1 0 9 9 9 255\r\n3 0 1 2\r\n"s,
          "STCOFF\n3 1 3\n0 0 0 1 1 1 .5 .5\n1 0 0 1 1 1 .5 .5\n0 1 0 1 1 1 .5 .5\n3 0 1 2\n"s}) {
        const Mesh mesh = mesh_of("a.off", text);
        CHECK(mesh.vertices == std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
        CHECK(mesh.triangles == std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}});
        CHECK(mesh.normals.empty());
    }
}

TEST_CASE("text PLY: properties that are passed over, in vertices and faces") {
    const Mesh mesh = mesh_of("a.ply",
                              "ply\nformat ascii 1.0\nelement vertex 4\nproperty uchar red\n"
                              "property float x\nproperty float z\nproperty float nx\n"
                              "property float y\nelement face 2\n"
                              "property list uint int vertex_indices\nproperty uchar red\n"
                              "property float q\nelement edge 1\nproperty int a\nend_header\n"
                              "9 0 0 7 0\n9\v1 0\f7 0\n9 1 0 7 1\n9 0 0 7 1\n"
                              "3 0 1 2 9 .5\n3 0 2 3 9 .5\n7\n");
    CHECK(mesh.vertices == std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
    CHECK(mesh.triangles == std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {0, 2, 3}});
    CHECK(mesh.normals.empty());  // nx alone is no normal
}

TEST_CASE("polygons become triangles, and faces without three corners are dropped") {
    const Mesh mesh = mesh_of("a.off",
                              "OFF\n6 6 0\n0 0 0\n2 0 0\n2 2 0\n1 0.5 0\n0 2 0\n9 9 9\n"
                              "5 0 1 2 3 4\n3 0 1 1\n4 0 0 1 2\n1 0\n0\n4 0 1 0 1\n");
    CHECK(mesh.vertices.size() == 6);   // one of them in no face
    CHECK(mesh.triangles.size() == 4);  // 3 of the first face, 1 of the third
    Real area = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
        const auto& v = mesh.vertices;
        area += cross(v[b] - v[a], v[c] - v[a]).z / 2;
    }
    CHECK(area == 4 - 1.5 + 2);  // the square less its notch, and the lower half of the square
}

TEST_CASE("normals of the file, made unit length") {
    const std::string body = "0 0 0 0 0 2\n1 0 0 0 3 4\n0 1 0 0 0 -1e-20\n";
    const std::vector<Vec3> expected = {{0, 0, 1}, {0, Real(0.6), Real(0.8)}, {0, 0, -1}};
    const std::string header =
        "ply\nformat ascii 1.0\nobj_info element x\nelement vertex 3\nproperty float x\n"
        "property float y\nproperty float z\nproperty float nx\nproperty float ny\n"
        "property float nz\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
    for (const Mesh& mesh : {mesh_of("a.off", "NOFF\n3 1 0\n" + body + "3 0 1 2\n"),
                             mesh_of("a.ply", header + body + "3 0 1 2\n"),
                             mesh_of("a.obj",
                                     "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 9 9 9\nvn 0 0 -1e-20\n"
                                     "vn 0 0 2\nvn 0 3 4\nf 1//2 2//3 3//-3\n")}) {
        REQUIRE(mesh.normals.size() == mesh.vertices.size());
        for (std::size_t i = 0; i < 3; ++i) {
            CHECK(glm::distance(mesh.normals[i], expected[i]) <= 2 * unit_roundoff + Real(1e-7));
        }
    }
}

TEST_CASE("a normal that is zero is made from the faces, and without all of them there are none") {
    const Mesh mesh =
        mesh_of("a.off", "NOFF\n3 1 0\n0 0 0 1 0 0\n1 0 0 0 0 0\n0 1 0 1 0 0\n3 0 1 2\n");
    REQUIRE(mesh.normals.size() == 3);
    CHECK(mesh.normals[1] == Vec3(0, 0, 1));
    CHECK(mesh.normals[2] == Vec3(1, 0, 0));
    CHECK(mesh_of("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 1 0 0\nf 1//1 2//1 3\n").normals.empty());
}

TEST_CASE("a vertex with a normal a face is split, as at the edges of a cube") {
    // Two walls that meet at right angles in the edge from 1 to 2.
    const Mesh mesh = mesh_of("a.obj",
                              "v 0 0 0\nv 0 1 0\nv 1 0 0\nv 0 0 1\nvn 0 0 1\nvn 1 0 0\n"
                              "f 1//1 3//1 2//1\nf 1//2 2//2 4//2\nf 3//1 2//1 1//1\n");
    CHECK(mesh.vertices.size() == 6);
    REQUIRE(mesh.normals.size() == 6);
    REQUIRE(mesh.triangles.size() == 3);
    const Vec3 expected[] = {{0, 0, 1}, {1, 0, 0}, {0, 0, 1}};
    for (std::size_t i = 0; i < 3; ++i) {
        for (const std::uint32_t corner : mesh.triangles[i]) {
            CHECK(mesh.normals[corner] == expected[i]);
        }
    }
}

TEST_CASE("smooth normals: a cube's point away from its middle, however its faces are cut") {
    const Mesh cube = mesh_of("cube.off", cube_off);
    const std::vector<Vec3> normals = smoothed(cube).normals;
    REQUIRE(normals.size() == 8);
    for (std::size_t i = 0; i < 8; ++i) {
        CHECK(glm::distance(normals[i], cube.vertices[i] / std::sqrt(Real(3))) <=
              8 * unit_roundoff);
    }
}

TEST_CASE("smooth normals: unit length at any size, and somewhere where there is no face") {
    for (const Real size : {Real(1e-18), Real(1), Real(1e18)}) {
        const Mesh mesh = {.vertices = {{0, 0, 0}, {size, 0, 0}, {0, size, 0}, {1, 2, 3}},
                           .triangles = {{0, 1, 2}, {0, 1, 1}}};
        CHECK(smoothed(mesh).normals == std::vector<Vec3>(4, Vec3(0, 0, 1)));
    }
}

TEST_CASE("the shipped meshes are as described in docs/reference/meshes.md") {
    struct Shipped {
        const char* file;
        Topology expected;
        bool has_normals = false;
    };
    const Shipped all[] = {
        {"cube.off", {.vertices = 8, .edges = 18, .triangles = 12, .parts = 1}},
        {"owl_cage.obj", {.vertices = 296, .edges = 786, .triangles = 524, .parts = 19}},
        {"owl.off", {.vertices = 4194, .edges = 12480, .triangles = 8320, .parts = 19}},
        {"pebble.ply", {.vertices = 642, .edges = 1920, .triangles = 1280, .parts = 1}, true},
        {"bowl.stl",
         {.vertices = 281, .edges = 800, .triangles = 520, .open_edges = 40, .parts = 1},
         true},
        {"book.off",
         {.vertices = 16,
          .edges = 29,
          .triangles = 14,
          .open_edges = 21,
          .shared_edges = 1,
          .parts = 1}},
    };
    for (const auto& [file, expected, has_normals] : all) {
        const Mesh mesh = load_mesh(std::string(RAYSTEPS_ROOT "/scenes/meshes/") + file);
        const Topology found = topology(mesh);
        INFO(file);
        CHECK(found.vertices == expected.vertices);
        CHECK(found.edges == expected.edges);
        CHECK(found.triangles == expected.triangles);
        CHECK(found.open_edges == expected.open_edges);
        CHECK(found.shared_edges == expected.shared_edges);
        CHECK(found.parts == expected.parts);
        CHECK(mesh.normals.size() == (has_normals ? mesh.vertices.size() : 0));
    }
}
