// Variants of the four formats, as programs write them: read, with a warning where something is
// odd.

#include "tests/common/mesh_file/reading.hpp"

#include "tests/kit/catch.hpp"

#include <algorithm>
#include <string>
#include <vector>

using namespace rt;
using namespace std::string_literals;

namespace {

const std::string three_points = "0 0 0\n1 0 0\n0 1 0\n";
const std::vector<Vec3> places = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

/// The warnings about the file or a line of it, after "warning: ". The file must be the triangle of
/// `places`.
std::vector<std::string> warnings_of_triangle(const std::string& name, const std::string& content) {
    INFO(name << "\n" << content);
    const MeshFolder folder;
    const std::string file = folder.write(name, content);
    std::vector<std::string> all;
    const Mesh mesh = load_mesh(file, [&](const std::string& warning) {
        REQUIRE(warning.starts_with(file + ":"));
        all.push_back(warning.substr(warning.find("warning: ") + 9));
    });
    REQUIRE(mesh.triangles.size() == 1);
    for (std::size_t i = 0; i < 3; ++i) CHECK(mesh.vertices[mesh.triangles[0][i]] == places[i]);
    return all;
}

using Warnings = std::vector<std::string>;

std::string binary_stl(std::string header, const std::string& more) {
    header.resize(80, ' ');
    std::string text = header + "\1\0\0\0"s + std::string(24, '\0') + "\0\0\x80\x3f"s +
                       std::string(12, '\0') + "\0\0\x80\x3f"s + std::string(6, '\0');
    return text + more;
}

std::string cr_only(std::string text) {
    std::ranges::replace(text, '\n', '\r');
    return text;
}

double area(const Mesh& mesh) {
    double sum = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
        const auto& v = mesh.vertices;
        sum += double(length(cross(v[b] - v[a], v[c] - v[a]))) / 2;
    }
    return sum;
}

}  // namespace

TEST_CASE("STL: before the first word, and after the last") {
    const std::string whole = "solid part\n" + facet + "endsolid part\n";
    for (const std::string& before :
         {""s, "\n\n"s, " \t  "s, "# by a program\n"s, "; a\n// b\n"s, "\xEF\xBB\xBF  "s,
          "\xEF\xBB\xBF# a\n\n"s, "written by a program\n"s})
        CHECK(warnings_of_triangle("a.stl", before + whole).empty());
    CHECK(warnings_of_triangle("a.stl", "solid\n" + facet + "end solid\n").empty());
    CHECK(warnings_of_triangle("a.stl", "solid\n# within\n" + facet + "ENDSOLID").empty());
    CHECK(warnings_of_triangle("a.stl",
                               "solid # 1\nouter loop # 2\nvertex 0 0 0 # 3\n#\n"
                               "vertex 1 0 0\nvertex 0 1 0\nendsolid\n# 4\n")
              .empty());
    CHECK(warnings_of_triangle("a.stl", "; c\rsolid a\r" + cr_only(facet) + "endsolid\r").empty());
    const std::string back = "facet\nouter loop\nvertex 0 1 0\nvertex 1 0 0\nvertex 0 0 0\n";
    for (const std::string& second : {facet, back})
        CHECK(warnings_of_triangle("a.stl", "solid\n" + facet + second + "endsolid") ==
              Warnings{"1 facet has the corners of another one: left out"});
    CHECK(warnings_of_triangle("a.stl", whole + "# the end\n\nsolid b\nendsolid b\n").empty());
    CHECK(warnings_of_triangle("a.stl", whole + "\nexported by a program\n") ==
          Warnings{"what follows \"endsolid\" is not read"});
    CHECK(warnings_of_triangle("a.stl", whole + "solid b\nfacet\n") ==
          Warnings{"has no \"endsolid\" at its end: its last facets may be missing"});
    CHECK(warnings_of_triangle("a.stl", "solid\n" + facet) ==
          Warnings{"has no \"endsolid\" at its end: its last facets may be missing"});
}

TEST_CASE("STL: binary that begins with solid, and with bytes too many") {
    CHECK(warnings_of_triangle("a.stl", binary_stl("exported", "")).empty());
    CHECK(warnings_of_triangle("a.stl", binary_stl("solid part", "")).empty());
    CHECK(warnings_of_triangle("a.stl", binary_stl("solid part", "\n")) ==
          Warnings{"a binary STL of 1 triangles has 134 bytes, not 135: the rest is not read"});
    CHECK(warnings_of_triangle("a.stl", binary_stl("m" + std::string(79, '\0'), "four")) ==
          Warnings{"a binary STL of 1 triangles has 134 bytes, not 138: the rest is not read"});
    for (const std::size_t more : {49, 50, 60, 1000})
        CHECK(warnings_of_triangle("a.stl", binary_stl("solid", std::string(more, 'z'))) ==
              Warnings{"a binary STL of 1 triangles has 134 bytes, not " +
                       std::to_string(134 + more) + ": the rest is not read"});
}

TEST_CASE("OFF: letters in any order, no keyword, faces over lines, counts on the first line") {
    const std::string face = "3 0 1 2\n";
    for (const std::string& text :
         {"3 1 0\n" + three_points + face, "3 1\n" + three_points + face,
          "OFF 3 1 0\n" + three_points + face, "OFF3 1 0\n" + three_points + face,
          "OFF\n3 1 0\n" + three_points + "3\n0 1\n\n2\n",
          "OFF\n3 1 0\n" + three_points + "3 0 1\n2 9 9 9\n",
          "CSTOFF\n3 1 0\n0 0 0 9 9 9 9 0 0\n1 0 0 9 9 9 9 0 0\n0 1 0 9 9 9 9 0 0\n" + face,
          "NOFF\n3 1 0\n" + three_points + face, "off\n3 1 0\n" + three_points + face,
          "noff3 +1 0\n" + three_points + face,
          cr_only("OFF\n# made by me\n3 1 0\n" + three_points + face)})
        CHECK(warnings_of_triangle("a.off", text).empty());
    // Geomview has the normal before the color, and MeshLab after it, and its letters as well.
    const auto vertices = [](const std::string& after) {
        return "0 0 0 " + after + "\n1 0 0 " + after + "\n0 1 0 " + after + "\n3 0 1 2\n";
    };
    for (const std::string& text :
         {"CNOFF\n3 1 0\n" + vertices("0 0.6 0.8 7 8 9 1"),
          "NCOFF\n3 1 0\n" + vertices("7 8 9 1 0 0.6 0.8"),
          "NCOFF\n3 1 0\n" + vertices("7 8 9 0 0.6 0.8"),
          "NCOFF\n3 1 0\n" + vertices("0 0.6 0.8 255 0 0 255"),  // as the length tells
          "CNOFF\n3 1 0\n" + vertices("255 0 0 255 0 0.6 0.8"),
          "CNOFF\n3 1 0\n" + vertices("0 0.6 0.8 1 0 0 1"),
          "STNCOFF\n3 1 0\n" + vertices("7 8 9 1 0 0.6 0.8 5 5"),
          "STCNOFF\n3 1 0\n" + vertices("0 0.6 0.8 7 8 9 1 5 5"),
          "NSTOFF\n3 1 0\n" + vertices("0 0.6 0.8 5 5")}) {
        INFO(text);
        const Mesh mesh = mesh_of("a.off", text);
        REQUIRE(mesh.normals.size() == 3);
        CHECK(length(mesh.normals[1] - Vec3(0, Real(0.6), Real(0.8))) <= 4 * unit_roundoff);
    }
    CHECK(mesh_refusal("a.off", "CCOFF\n").ends_with("expected OFF, not \"CCOFF\""));
    CHECK(mesh_refusal("a.off", "XOFF\n").ends_with("expected OFF, not \"XOFF\""));
}

TEST_CASE("OBJ: normals that are missing, zero or not a number are computed") {
    const std::string v = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    const auto warnings = [&](const std::string& rest) {
        return warnings_of_triangle("a.obj", v + rest);
    };
    const std::string computed = " zero or not a number: computed from the faces";
    for (const std::string& none :
         {"nan nan nan"s, "0 0 0"s, "-nan(ind) 0 0"s, "0 0 -1.#IND"s, "1.#QNAN0 1 0"s, "inf 0 0"s,
          "NaN NaN NaN"s, ""s, "0 1"s, " # none"s}) {
        CHECK(warnings("vn 0 0 1\nvn " + none + "\nf 1//1 2//2 3//1\n") ==
              Warnings{"1 normal is" + computed});
        const Mesh mesh = mesh_of("a.obj", v + "vn 1 0 0\nvn " + none + "\nf 1//1 2//2 3//1\n");
        REQUIRE(mesh.normals.size() == 3);
        CHECK(mesh.normals[0] == Vec3(1, 0, 0));
        CHECK(mesh.normals[1] == Vec3(0, 0, 1));
    }
    const std::string lost = " not in the file: computed from the faces";
    CHECK(warnings("f 1//1 2//2 3//3\n") == Warnings{"3 corners name normals that are" + lost});
    for (const std::string& index : {"0"s, "2"s, "-2"s, "-9223372036854775808"s})
        CHECK(warnings("vn 0 0 1\nf 1//1 2//1 3//" + index + "\n") ==
              Warnings{"1 corner names a normal that is" + lost});
    const Mesh last = mesh_of("a.obj", v + "vn 1 0 0\nvn 0 1 0\nf 1//-1 2//-2 3//-1\n");
    REQUIRE(last.normals.size() == 3);
    CHECK(last.normals[0] == Vec3(0, 1, 0));
    CHECK(last.normals[1] == Vec3(1, 0, 0));
    CHECK(warnings("vn 0 0 1 # up\nf 1/x/1 2/9.5/1 3/0/1\n").empty());  // of textures, nothing
}

TEST_CASE("OBJ: names and paths that end in a backslash; colors of nan; faces before vertices") {
    const std::string v = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    for (const std::string& name : {"mtllib C:\\models\\"s, "o a\\"s, "g b c\\"s, "usemtl d\\"s})
        CHECK(warnings_of_triangle("a.obj", name + "\n" + v + name + "\nf 1 2 3\n").empty());
    CHECK(
        warnings_of_triangle("a.obj", "f 1 2 3\nv 0 0 0 nan nan nan\nv 1 0 0\nv 0 1 0\n").empty());
    CHECK(warnings_of_triangle("a.obj", v + "f 1 2 3 \\").empty());
    CHECK(warnings_of_triangle("a.obj", v + "f 1 \\\n2 3\\\n").empty());
    CHECK(warnings_of_triangle("a.obj", v + "f +1 +2/ +3\n").empty());
    CHECK(warnings_of_triangle("a.obj", v + "f 1 \\\n 2 \\\n\n3\nf 1 2 3\n").size() == 1);
}

TEST_CASE("PLY: elements and properties of every kind around those that are read") {
    const auto ply = [](const std::string& vertex, const std::string& elements,
                        const std::string& body) {
        return "ply\nformat ascii 1.0\nelement vertex 3\n" + vertex + elements + "end_header\n" +
               body;
    };
    const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
    const std::string integers = "property int x\nproperty short y\nproperty uchar z\n";
    const std::string list = "property list uchar int vertex_indices\n";
    const std::string face = "element face 1\n" + list;
    const std::string edge = "element edge 1\nproperty int a\nproperty int b\n";
    for (const std::string& text :
         {ply(integers, face, three_points + "3 0 1 2\n"),
          ply(xyz, "element face 1\n" + list + "property list uchar float texcoord\n",
              three_points + "3 0 1 2 6 0 0 1 0 0 1\n"),
          ply(xyz, "element face 1\nproperty list uchar float texcoord\n" + list,
              three_points + "6 0 0 1 0 0 1 3 0 1 2\n"),
          ply(xyz, "element face 1\nproperty int flags\n" + list, three_points + "7 3 0 1 2\n"),
          ply("property float X\nproperty float Y\nproperty float Z\n", face,
              three_points + "3 0 1 2\n"),
          ply(xyz, edge + face, three_points + "0 1\n3 0 1 2\n"),
          ply("property list uchar int scan\n" + xyz, face,
              "0 0 0 0\n2 7 7 1 0 0\n1 7 0 1 0\n3 0 1 2\n"),
          ply(xyz, "element tristrips 1\nproperty list int int vertex_indices\n",
              three_points + "3 0 1 2\n"),
          ply(xyz, "element tristrips 1\nproperty list int int vertex_indices\n",
              three_points + "9 0 0 1 -1 0 1 2 2 -1\n")})
        CHECK(warnings_of_triangle("a.ply", text).empty());
    CHECK(warnings_of_triangle("a.ply",
                               ply(xyz, face, "0 0 0 # a\ncomment b\n1 0 0\n0 1 0\n3 0 1 2 # b\n"))
              .empty());
    // Their name, if they are the only list of whole numbers.
    for (const std::string& element : {"face"s, "tristrips"s})
        CHECK(warnings_of_triangle(
                  "a.ply", ply(xyz,
                               "element " + element + " 1\nproperty list int int Vertices\n" +
                                   "property list uchar float uv\n",
                               three_points + "3 0 1 2 0\n")) ==
              Warnings{"the list \"vertices\" is read as vertex_indices"});
    // Faces first.
    CHECK(warnings_of_triangle("a.ply", "ply\nformat ascii 1.0\n" + face + "element vertex 3\n" +
                                            xyz + "end_header\n3 0 1 2\n" + three_points)
              .empty());
}

TEST_CASE("PLY: binary, with elements and lists around those that are read") {
    const std::string one = "\0\0\x80\x3f"s;
    const std::string zero(4, '\0');
    const std::string vertices = zero + zero + zero + one + zero + zero + zero + one + zero;
    const std::string face = "\3\0\1\2"s;
    const std::string start = "ply\nformat binary_little_endian 1.0\n";
    const std::string of_vertices =
        "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
    const std::string list = "property list uchar uchar vertex_indices\n";
    const std::string end = "end_header\n";
    CHECK(warnings_of_triangle("a.ply", start + "element face 1\nproperty list uchar float uv\n" +
                                            list + of_vertices + end + "\1" + one + face + vertices)
              .empty());
    CHECK(warnings_of_triangle("a.ply", start + "element edge 2\nproperty short a\n" + of_vertices +
                                            "element face 1\n" + list +
                                            "property list ushort double uv\n" + end + "abcd" +
                                            vertices + face + "\1\0"s + std::string(8, 'x'))
              .empty());
    // A header whose lines end in CR; the first byte after it may be that of LF.
    CHECK(warnings_of_triangle("a.ply", cr_only(start + "element edge 1\nproperty short a\n" +
                                                of_vertices + "element face 1\n" + list + end) +
                                            "\n\r" + vertices + face)
              .empty());
    const std::string strip =
        "\5\0\0\0"s + zero + "\1\0\0\0"s + "\2\0\0\0"s + "\xff\xff\xff\xff"s + zero;
    CHECK(warnings_of_triangle(
              "a.ply", start + of_vertices +
                           "element tristrips 1\nproperty list int int vertex_indices\n" + end +
                           vertices + strip)
              .empty());
}

TEST_CASE("OFF and PLY with more than the header counts") {
    const std::string off = "OFF\n3 1 0\n" + three_points + "3 0 1 2\n";
    CHECK(mesh_warnings("a.off", off + "# the end\n\n \n").empty());
    CHECK(mesh_warnings("a.off", off + "\n3 0 2 1\n3 0 1 2\n") ==
          Warnings{"a.off:8: warning: the header counts 1 face: what follows is not read"});
    const std::string ply =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
        "property float z\nelement face 1\nproperty list uchar uchar vertex_indices\n"
        "end_header\n";
    const std::string text = ply + three_points + "3 0 1 2\n";
    CHECK(mesh_warnings("a.ply", text + "comment the end\n\n").empty());
    CHECK(mesh_warnings("a.ply", text + "3 0 2 1\n") ==
          Warnings{"a.ply:14: warning: the header counts no more items: what follows is not read"});
    std::string bytes = ply;
    bytes.replace(bytes.find("ascii"), 5, "binary_big_endian");
    const std::string one = "\x3f\x80\0\0"s;
    const std::string zero(4, '\0');
    bytes += zero + zero + zero + one + zero + zero + zero + one + zero + "\3\0\1\2"s;
    CHECK(mesh_warnings("a.ply", bytes).empty());
    CHECK(mesh_warnings("a.ply", bytes + "\n") ==
          Warnings{"a.ply: warning: the header counts no more items: the last byte is not read"});
    CHECK(mesh_warnings("a.ply", bytes + "\3\0\2\1"s) ==
          Warnings{"a.ply: warning: the header counts no more items: the last 4 bytes are not "
                   "read"});
}

TEST_CASE("a strip of triangles: every second is turned") {
    const Mesh mesh =
        mesh_of("a.ply",
                "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\n"
                "property float z\nelement tristrips 1\nproperty list int int vertex_indices\n"
                "end_header\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n5 0 1 2 3 4\n");
    CHECK(mesh.triangles ==
          std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {2, 1, 3}, {2, 3, 4}});
}

TEST_CASE("a polygon with a hole, joined to it by a bridge, has its area in every format") {
    // A plate of 5 x 4 with a hole of 2 x 1: the corners of the bridge are there twice.
    const std::vector<std::string> points = {"0 0 0", "5 0 0", "5 4 0", "0 4 0",
                                             "1 1 0", "1 2 0", "3 2 0", "3 1 0"};
    std::string off = "OFF\n8 1 0\n";
    std::string obj;
    std::string ply = ply_header(8, 1);
    for (const std::string& point : points) {
        off += point + "\n";
        ply += point + "\n";
        obj += "v " + point + "\n";
    }
    const std::string face = "10 0 1 2 3 0 4 5 6 7 4\n";
    CHECK(area(mesh_of("a.off", off + face)) == 18);
    CHECK(area(mesh_of("a.ply", ply + face)) == 18);
    CHECK(area(mesh_of("a.obj", obj + "f 1 2 3 4 1 5 6 7 8 5\n")) == 18);
}

TEST_CASE("a pointer of Git LFS is named as such") {
    const std::string pointer =
        "version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 9\n";
    for (const char* name : {"a.off", "a.obj", "a.ply", "a.stl"})
        CHECK(mesh_refusal(name, pointer)
                  .ends_with("is a pointer of Git LFS, not the mesh: run git lfs pull"));
}
