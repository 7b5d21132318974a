// The errors of a wrong mesh: the place, the mistake, and the expected words.

#include "tests/common/mesh_file/reading.hpp"

#include "tests/kit/catch.hpp"

#include <ctime>
#include <string>
#include <vector>

using namespace rt;
using namespace std::string_literals;

namespace {

struct Wrong {
    std::string file;
    std::string content;
    std::string message;  ///< after the file's name
};

void check(const std::vector<Wrong>& all) {
    for (const auto& [file, content, message] : all) {
        CHECK(mesh_refusal(file, content) == file + message);
    }
}

/// The header of three vertices and a face, with one thing in it replaced.
std::string ply_with(const std::string& what, const std::string& by) {
    std::string text = ply_header(3, 1) + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    const std::size_t at = text.find(what);
    REQUIRE(at != std::string::npos);
    return text.replace(at, what.size(), by);
}

std::string no_statement(const std::string& keyword) {
    return ": error: has no face, and OBJ has no statement \"" + keyword +
           "\": expected v, vn or f";
}

/// The text in UTF-16, of which the odd bytes are 0, or in the other byte order the even ones.
std::string in_utf16(const std::string& text, bool is_big) {
    std::string result;
    for (const char c : text) result += is_big ? "\0"s + c : c + "\0"s;
    return result;
}

std::string binary_stl(char count, std::size_t size) {
    std::string text(size, '\0');
    text[80] = count;
    return text;
}

}  // namespace

TEST_CASE("files that are no mesh") {
    check({
        {"a.off", "", ": error: is empty: expected a mesh"},
        {"a.txt", "OFF",
         ": error: is not a mesh: expected a name that ends in .off, .obj, .ply or .stl"},
        {"off", "OFF",
         ": error: is not a mesh: expected a name that ends in .off, .obj, .ply or .stl"},
        {"a.obj", "\xFF\xFEv\0 \0"s,
         ": error: text in UTF-16 or UTF-32: expected UTF-8, as which an editor can save it"},
        {"a.off", "ply\n", ":1: error: expected OFF, not \"ply\""},
        {"a.off", "\n\n", ":2: error: expected OFF, not \"\""},
        {"a.ply", "OFF\n", ":1: error: expected ply, not \"OFF\""},
        {"a.stl", "OFF\n",
         ": error: is not STL: expected \"solid\" or a binary header, not \"OFF\""},
        {"a.obj", "OFF\n3 1 0\n", ":1" + no_statement("OFF")},
        {"a.obj", "\0\xff\x1b"s, ":1" + no_statement("\\x00\\xFF\\x1B")},
        {"a.obj", "# no case\nV 0 0 0\nV 1 0 0\nV 0 1 0\nF 1 2 3\n", ":2" + no_statement("V")},
        {"a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nfo 1 2 3\n", ":5" + no_statement("fo")},
        {"a.obj", "<!DOCTYPE html>\n<html>\n", ":1" + no_statement("<!DOCTYPE")},
        {"a.obj", "solid a\nfacet normal 0 0 1\n", ":1" + no_statement("solid")},
        {"a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 0\n",
         ": error: has no triangles: 1 face has fewer than three different corners"},
        {"a.obj", "v 0 0 0\nv 1 0 0\nf 1 2 1\nf 1 1 1\n",
         ": error: has no triangles: 2 faces have fewer than three different corners"},
    });
    const MeshFolder folder;
    const auto refusal = [](const std::string& file) {
        try {
            static_cast<void>(load_mesh(file));
            return "accepted"s;
        } catch (const InputError& error) {
            return std::string(error.what());
        }
    };
    const std::string absent = (folder.path / "absent.off").string();
    CHECK(refusal(absent) == absent + ": error: no such file");
    const std::string inside = (folder.path / "folder.off").string();
    std::filesystem::create_directories(inside);
    CHECK(refusal(inside) == inside + ": error: is a directory: expected a file");
}

TEST_CASE("text in UTF-16 is named as such, with a byte order mark or without") {
    const std::string stl = "solid a\n" + facet + "endsolid a\n";
    for (const bool is_big : {false, true})
        for (const std::string& mark : {""s, is_big ? "\xFE\xFF"s : "\xFF\xFE"s})
            for (const auto& [name, content] :
                 std::vector<std::pair<std::string, std::string>>{{"a.obj", "v 0 0 0\n"},
                                                                  {"a.off", "OFF\n"},
                                                                  {"a.ply", "ply\n"},
                                                                  {"a.stl", stl}})
                CHECK(mesh_refusal(name, mark + in_utf16(content, is_big)) ==
                      name +
                          ": error: text in UTF-16 or UTF-32: expected UTF-8, as which an "
                          "editor can save it");
    CHECK(mesh_refusal("a.obj", "v\0\0\0 \0\0\0"s).ends_with("as which an editor can save it"));
}

TEST_CASE("a byte order mark is skipped in every text format") {
    const std::string mark = "\xEF\xBB\xBF";
    const std::vector<std::pair<std::string, std::string>> files = {
        {"a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
        {"a.off", "# a comment\nOFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
        {"a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
        {"a.ply", ply_header(3, 1) + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
        {"a.stl", "solid a\n" + facet + "endsolid a\n"},
    };
    for (const auto& [name, content] : files) {
        INFO(name);
        const Mesh mesh = mesh_of(name, mark + content);
        CHECK(mesh.vertices == mesh_of(name, content).vertices);
        CHECK(mesh.triangles.size() == 1);
    }
    // Lines are counted as without it.
    CHECK(mesh_refusal("a.obj", mark + "v 0 0 0\nv 1 0\n").starts_with("a.obj:2: error: "));
}

TEST_CASE("faces and meshes without area are warned of") {
    const auto warnings = [](const std::string& name, const std::string& content) {
        std::vector<std::string> all = mesh_warnings(name, content);
        for (std::string& warning : all) {
            REQUIRE(warning.starts_with(name + ": warning: "));
            warning.erase(0, name.size() + 11);
        }
        return all;
    };
    using Warnings = std::vector<std::string>;
    const std::string four = "0 0 0\n1 0 0\n0 1 0\n2 0 0\n";
    const std::string few = "fewer than three different corners, and no area: left out";
    CHECK(warnings("a.off", "OFF\n4 1 0\n" + four + "3 0 1 2\n").empty());
    CHECK(warnings("a.off", "OFF\n4 2 0\n" + four + "3 0 1 2\n2 0 1\n") ==
          Warnings{"1 face has " + few});
    CHECK(warnings("a.off", "OFF\n4 4 0\n" + four + "3 0 1 2\n0\n1 2\n3 0 0 1\n") ==
          Warnings{"3 faces have " + few});
    CHECK(warnings("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 1 2\n") ==
          Warnings{"1 face has " + few});
    CHECK(warnings("a.off", "OFF\n4 2 0\n" + four + "3 0 1 2\n4 0 1 0 1\n") ==
          Warnings{"1 face has " + few});
    CHECK(warnings("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 1 2\n") ==
          Warnings{"1 face has " + few});
    std::string line = facet;
    line.replace(line.find("0 1 0"), 5, "0 0 0");
    CHECK(warnings("a.stl", "solid\n" + facet + line + "endsolid\n") ==
          Warnings{"1 face has " + few});
    std::string binary = binary_stl(2, 84 + 100);
    binary.replace(84 + 24, 4, "\0\0\x80\x3f"s);  // the second corner is 1,0,0
    binary.replace(84 + 40, 4, "\0\0\x80\x3f"s);  // the third is 0,1,0
    CHECK(warnings("a.stl", binary) == Warnings{"1 face has " + few});
    CHECK(warnings("a.off", "OFF\n4 1 0\n" + four + "3 0 1 3\n") ==
          Warnings{"no triangle has an area: no ray hits the mesh"});
    CHECK(warnings("a.off", "OFF\n4 2 0\n" + four + "3 0 1 3\n3 0 1 2\n").empty());
}

TEST_CASE("a file above 512 MiB") {
    const MeshFolder folder;
    const std::string file = folder.write("a.off", "OFF\n");
    // zeros, which use no space on the disk
    std::filesystem::resize_file(file, (std::uintmax_t(512) << 20) + 1);
    CHECK_THROWS_WITH(load_mesh(file),
                      file + ": error: is larger than 512 MiB: expected a smaller mesh");
}

TEST_CASE("OFF") {
    const std::string three = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n";
    check({
        {"a.off", "OFF", ":1: error: expected the number of vertices, not \"\""},
        {"a.off", "OFF\n3 x 0\n", ":2: error: expected the number of faces, not \"x\""},
        {"a.off", "OFF\n-3 1 0\n", ":2: error: expected the number of vertices, not \"-3\""},
        {"a.off", "OFF\n99999999999999999999 1 0\n",
         ":2: error: expected the number of vertices, not \"99999999999999999999\""},
        {"a.off", "OFF\n1000000000000000000 1 0\n0 0 0\n",
         ":3: error: the file ends after 1 of 1000000000000000000 vertices: each needs a line of "
         "its own"},
        {"a.off", "OFF\n3 1000000000000000000 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
         ":6: error: the file ends after 1 of 1000000000000000000 faces: each needs a line of its "
         "own"},
        {"a.off", "OFF\n0 1 0\n3 0 1 2\n", ":3: error: vertex 0 is not there: the file has none"},
        {"a.off", "OFF\n0 0 0\n", ": error: has no triangles: expected at least one"},
        {"a.off", "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n",
         ": error: has no triangles: expected at least one"},
        {"a.off", "OFF 3 1 0 0 0 0 1 0 0 0 1 0 3 0 1 2\n",
         ":1: error: expected the numbers of vertices, faces and edges, and then one vertex a "
         "line, not \"0\""},
        {"a.off", "OFF\n3 1 0 0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
         ":2: error: expected the numbers of vertices, faces and edges, and then one vertex a "
         "line, not \"0\""},
        {"a.off", three + "3 0 0 1\n",
         ": error: has no triangles: 1 face has fewer than three different corners"},
        {"a.off", "OFF\n3 1 0\n0 0 0\n1 0\n0 1 0\n3 0 1 2\n",
         ":4: error: a vertex has 3 numbers here, on a line of its own, not 2"},
        {"a.off", "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 3 2 1 0\n",
         ":6: error: the file ends after 1 of 2 faces: each needs a line of its own"},
        {"a.off", three,
         ":5: error: the file ends after 0 of 1 faces: each needs a line of its own"},
        {"a.off", three + "3 0 1\n", ":6: error: a face of 3 corners ends after 2"},
        {"a.off", three + "x 0 1 2\n",
         ":6: error: a face begins with the number of its corners, not \"x\""},
        {"a.off", three + "-1 0 1 2\n",
         ":6: error: a face begins with the number of its corners, not \"-1\""},
        {"a.off", three + "4097 0 1 2\n",
         ":6: error: a face of 4097 corners: expected at most 4096"},
        {"a.off", three + "3 0 1 3\n", ":6: error: vertex 3 is not there: expected 0 to 2"},
        {"a.off", three + "# again\n3 0 1 -1\n",
         ":7: error: vertex -1 is not there: expected 0 to 2"},
        {"a.off", three + "3 0 1 2.5\n",
         ":6: error: expected a number in the range of float, or an existing vertex, not \"2.5\""},
        {"a.off", "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2+3\n3 0 1 2\n",
         ":6: error: expected a number in the range of float, or an existing vertex, not \"2+3\""},
        {"a.off", "OFF\n3 1 0\n0 0 0\n1 0 0-3\n0 1 0\n3 0 1 2\n",
         ":4: error: expected a number in the range of float, or an existing vertex, not \"0-3\""},
        {"a.off", three + "3 0 two 1\n",
         ":6: error: expected a number in the range of float, or an existing vertex, not \"two\""},
        {"a.off", "OFF\n3 1 0\n0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n",
         ":4: error: expected a number in the range of float, or an existing vertex, not \"nan\""},
        {"a.off", "OFF\n3 1 0\n0 0 0\n1 0 -inf\n0 1 0\n3 0 1 2\n",
         ":4: error: expected a number in the range of float, or an existing vertex, not \"-inf\""},
        {"a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n1e300 1 0\n3 0 1 2\n",
         ":5: error: expected a number in the range of float, or an existing vertex, not "
         "\"1e300\""},
        {"a.off", "4OFF\n3 1 0\n",
         ":1: error: \"4OFF\" is not read: expected vertices of three "
         "dimensions"},
        {"a.off", "OFF BINARY\n\1\2\3", ":1: error: binary OFF is not read: save it as text"},
    });
}

TEST_CASE("OBJ") {
    const std::string three = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    check({
        {"a.obj", three, ": error: has no triangles: expected at least one"},
        {"a.obj", three + "f 1 1 2\n",
         ": error: has no triangles: 1 face has fewer than three different corners"},
        {"a.obj", "v 0 0 0 v 1 0 0 v 0 1 0 f 1 2 3\n",
         ":1: error: a vertex is on a line of its own, followed here by \"v\""},
        {"a.obj", three + "vn 0 0 1 f\n",
         ":4: error: a normal is on a line of its own, followed here by \"f\""},
        {"a.obj", three + "f 1 2\n",
         ": error: has no triangles: 1 face has fewer than three different corners"},
        {"a.obj", three + "f\n",
         ": error: has no triangles: 1 face has fewer than three different corners"},
        {"a.obj", "v 0 0\n", ":1: error: a vertex must be three numbers up to 3.4e38, not \"\""},
        {"a.obj", "v 0 0 1e39\n",
         ":1: error: a vertex must be three numbers up to 3.4e38, not \"1e39\""},
        {"a.obj", "v 0 \\\n0 \\\n0\nv 0 0 x\n",  // the number of the line, as in the file
         ":4: error: a vertex must be three numbers up to 3.4e38, not \"x\""},
        {"a.obj", three + "f 1 2 \\\n",
         ": error: has no triangles: 1 face has fewer than three different corners"},
        {"a.obj", three + "f +-1 2 3\n",
         ":4: error: a corner's vertex must be a whole number other than 0, not \"+-1\""},
        {"a.obj", "v 0 0 inf\n",
         ":1: error: a vertex must be three numbers up to 3.4e38, not \"inf\""},
        {"a.obj", "v 0 0x1 0\n",
         ":1: error: a vertex must be three numbers up to 3.4e38, not \"0x1\""},
        {"a.obj", three + "vn 1 0 z\n",
         ":4: error: a normal must be three numbers up to 3.4e38, not \"z\""},
        {"a.obj", three + "f 1 2 0\n",
         ":4: error: a corner's vertex must be a whole number other than 0, not \"0\""},
        {"a.obj", three + "f 1 2 x\n",
         ":4: error: a corner's vertex must be a whole number other than 0, not \"x\""},
        {"a.obj", three + "f /1 2 3\n",
         ":4: error: a corner's vertex must be a whole number other than 0, not \"\""},
        {"a.obj", three + "f 1 2 9999999999\n",
         ":4: error: a corner's vertex must be from 1 to 3, not \"9999999999\""},
        {"a.obj", "f 1 2 3\n",
         ":1: error: a corner's vertex must be in the file, which has none, not \"1\""},
        {"a.obj", three + "f 1 2 4\n\n#\n",
         ":4: error: a corner's vertex must be from 1 to 3, not \"4\""},
        {"a.obj", three + "f -1 -2 -4\nv 1 1 1\n",
         ":4: error: a corner's vertex must be one of the 3 before it, not \"-4\""},
        {"a.obj", three + "f -1 -2 -9223372036854775808\n",
         ":4: error: a corner's vertex must be one of the 3 before it, not "
         "\"-9223372036854775808\""},
        {"a.obj", three + "f 1//x 2 3\n",
         ":4: error: a corner's normal must be a whole number other than 0, not \"x\""},
        {"a.obj", "v 0 0 -1.#IND\n",
         ":1: error: a vertex must be three numbers up to 3.4e38, not \"-1.#IND\""},
        {"a.obj", three + "vn 0 0 1\nf 1/1/1/1 2 3\n",
         ":5: error: a corner's normal must be a whole number other than 0, not \"1/1\""},
    });
}

TEST_CASE("PLY") {
    const auto numbers = [](const std::string& text) { return ply_with("0 0 0\n", text); };
    check({
        {"a.ply", "ply\n", ":1: error: the file ends before its end_header"},
        {"a.ply", "ply\nelement\n", ":2: error: expected the number of elements, not \"\""},
        {"a.ply", "ply\nproperty float x\n",
         ":2: error: expected format, element, property or end_header, not \"property\""},
        {"a.ply", "ply\nformat ascii 2.0\nend_header\n",
         ":2: error: expected version 1.0, not \"2.0\""},
        {"a.ply", "ply\nformat ascii\nend_header\n", ":2: error: expected version 1.0, not \"\""},
        {"a.ply", "ply\nend_header\n",
         ": error: expected the format ascii, binary_little_endian or binary_big_endian, not \"\""},
        {"a.ply", "ply\nformat ascii 1.0\nend_header\n",
         ": error: has 0 elements vertex: expected one"},
        {"a.ply", ply_with("element face 1\nproperty list uchar int vertex_indices\n", ""),
         ": error: has no element face, and so no surface: points cannot be drawn"},
        {"a.ply", ply_with("ascii", "morse"),
         ": error: expected the format ascii, binary_little_endian or binary_big_endian, not "
         "\"morse\""},
        {"a.ply", ply_with("vertex 3", "vertex -3"),
         ":3: error: expected the number of elements, not \"-3\""},
        {"a.ply", ply_with("float y", "long y"),
         ":5: error: expected the type of a property, such as float, not \"long\""},
        {"a.ply", ply_with("float y", "float"),
         ":5: error: expected the name of a property after its type"},
        {"a.ply", ply_with("float y", "float w"),
         ":3: error: a vertex has 0 properties y: expected one"},
        {"a.ply", ply_with("float y", "float x"),
         ":3: error: a vertex has 2 properties x: expected one"},
        {"a.ply", ply_with("float y", "list uchar float y"),
         ":5: error: a vertex's y is a list: expected a number"},
        {"a.ply", ply_with("list uchar int vertex_indices", "int corners"),
         ":7: error: a face has 0 lists vertex_indices: expected one"},
        {"a.ply",
         ply_with("vertex_indices", "corners\nproperty list uchar int flags\nproperty int a"),
         ":7: error: a face has 0 lists vertex_indices, and the lists \"corners\", \"flags\": "
         "expected one"},
        {"a.ply", ply_with("int vertex_indices", "float uv"),
         ":7: error: a face has 0 lists vertex_indices, and the lists \"uv\": expected one"},
        {"a.ply", ply_with("uchar int", "uchar float"),
         ":8: error: \"vertex_indices\" must be a list of whole numbers"},
        {"a.ply", ply_with("list uchar int", "int"),
         ":8: error: \"vertex_indices\" must be a list of whole numbers"},
        {"a.ply", ply_with("end_header", "property list float int flags\nend_header"),
         ":9: error: the length of the list \"flags\" must be a whole number, as uchar or int, not "
         "a float"},
        {"a.ply", ply_with("list uchar", "list float64"),
         ":8: error: the length of the list \"vertex_indices\" must be a whole number, as uchar or "
         "int, not a float64"},
        {"a.ply", ply_with("face 1", "face 3") + "3 2 1 0 3 0 1 2\n",  // two on the last line
         ":14: error: the file ends after 2 of 3 faces: each needs a line of its own"},
        {"a.ply", ply_with("element face 1\n", "element edge 1\nproperty int a\nelement face 1\n"),
         ":15: error: the file ends after 0 of 1 faces: each needs a line of its own"},
        {"a.ply", ply_with("vertex 3", "vertex 1000000000000000000"),
         ":13: error: a vertex has 3 numbers here, on a line of its own, not 4"},
        {"a.ply", ply_with("face 1", "face 1000000000000000000"),
         ":13: error: the file ends after 1 of 1000000000000000000 faces: each needs a line of its "
         "own"},
        {"a.ply", numbers("0 0\n"),
         ":10: error: a vertex has 3 numbers here, on a line of its own, not 2"},
        {"a.ply", ply_with("float z\n", "float z\nproperty uchar red\n"),
         ":11: error: a vertex has 4 numbers here, on a line of its own, not 3"},
        {"a.ply", numbers("0 0 1e39\n"),
         ":10: error: expected a number in the range of float, or an existing vertex, not "
         "\"1e39\""},
        {"a.ply", numbers("0 - 0\n"),
         ":10: error: expected a number in the range of float, or an existing vertex, not \"-\""},
        {"a.ply", ply_with("3 0 1 2", "3 0 1 3"),
         ":13: error: vertex 3 is not there: expected 0 to 2"},
        {"a.ply", ply_with("3 0 1 2", "4 0 1 2"),
         ":13: error: a face ends after 4 numbers of its line"},
    });
}

TEST_CASE("PLY with 50,000 properties a vertex is read in less than 3 s of a processor") {
    std::string properties = "property float z\n";
    for (int i = 0; i < 50'000; ++i) properties += "property float q\n";
    const std::clock_t start = std::clock();
    CHECK(mesh_refusal("a.ply", ply_with("property float z\n", properties)) ==
          "a.ply:50010: error: a vertex has 50003 numbers here, on a line of its own, not 3");
    CHECK(std::clock() - start < 3 * CLOCKS_PER_SEC);
}

TEST_CASE("binary PLY") {
    std::string header = ply_header(3, 1);
    header.replace(header.find("ascii"), 5, "binary_little_endian");
    const std::string vertices = "\0\0\0\0\0\0\0\0\0\0\0\0"s + "\0\0\x80\x3f\0\0\0\0\0\0\0\0"s +
                                 "\0\0\0\0\0\0\x80\x3f\0\0\0\0"s;
    const std::string face = "\3\0\0\0\0\1\0\0\0\2\0\0\0"s;
    const std::string whole = header + vertices + face;
    CHECK(mesh_refusal("a.ply", whole) == "accepted");

    const auto with = [&whole](const std::string& what, const std::string& by) {
        std::string text = whole;
        const std::size_t at = text.find(what);
        REQUIRE(at != std::string::npos);
        return text.replace(at, what.size(), by);
    };
    check({
        {"a.ply", header, ":3: error: the file ends too early for 3 vertices"},
        {"a.ply", header + vertices, ":7: error: the file ends too early for 1 faces"},
        {"a.ply", whole.substr(0, whole.size() - 1), ": error: the file ends too early"},
        {"a.ply", with("vertex 3", "vertex 1000000000000000000"),
         ":3: error: the file ends too early for 1000000000000000000 vertices"},
        {"a.ply", with("vertex 3", "vertex 4"),
         ": error: has no triangles: 1 face has fewer than three different corners"},
        {"a.ply", with("vertex 3", "vertex 2"),
         ": error: has no triangles: 1 face has fewer than three different corners"},
        {"a.ply", with("face 1", "face 4294967297"),
         ":7: error: the file ends too early for 4294967297 faces"},
        {"a.ply", with("face 1", "face 2"), ": error: the file ends too early"},
        {"a.ply", with("\2\0\0\0"s, "\3\0\0\0"s),
         ": error: vertex 3 is not there: expected 0 to 2"},
        {"a.ply", with("\2\0\0\0"s, "\xff\xff\xff\xff"),
         ": error: vertex -1 is not there: expected 0 to 2"},
        {"a.ply", with("\3\0\0\0"s, "\xff\0\0\0"s), ": error: the file ends too early"},
        {"a.ply", with("\0\0\x80\x3f"s, "\0\0\xc0\x7f"s),
         ": error: vertex 1 is not a place: expected three numbers up to 3.4e38"},
        {"a.ply", with("\0\0\x80\x3f"s, "\0\0\x80\xff"s),
         ": error: vertex 1 is not a place: expected three numbers up to 3.4e38"},
    });
    // 1e300, which a double can represent and a float cannot.
    const std::string far_away = "\0\0\0\0\0\0\0\0\x9c\x75\0\x88\x3c\xe4\x37\x7e"s;
    std::string doubles = header + far_away + std::string(32, '\0') + face;
    doubles.replace(doubles.find("float z"), 7, "double z");
    CHECK(mesh_refusal("a.ply", doubles) ==
          "a.ply: error: vertex 0 is not a place: expected three numbers up to 3.4e38");
}

TEST_CASE("STL") {
    const std::string no_loop = "has no triangles: no line begins with \"outer loop\"";
    check({
        {"a.stl", "solid x", ":1: error: " + no_loop},
        {"a.stl", "solid x\nendsolid x\n", ":2: error: " + no_loop},
        {"a.stl", "solid x\n" + facet + "facet normal 0 0 1\nouter loop\nvertex 0 0 0\n",
         ":11: error: the file ends within a facet"},
        {"a.stl", "solid x\nouter loop\nvertex 0 0 0\nendloop\n",
         ":4: error: expected \"vertex x y z\" at the start of a line, not \"endloop\""},
        {"a.stl", "solid x\nvertex 0 0 0\n",
         ":2: error: expected \"facet\" or \"outer loop\" at the start of a line, not \"vertex 0 0 "
         "0\""},
        {"a.stl", "solid x\nouter loop\nvertex 0 0\n",
         ":3: error: a vertex must be three numbers up to 3.4e38, not \"\""},
        {"a.stl", "solid x\nouter loop\nvertex 0 0 nan\n",
         ":3: error: a vertex must be three numbers up to 3.4e38, not \"nan\""},
        {"a.stl", binary_stl(2, 84 + 50),
         ": error: a binary STL of 2 triangles has 184 bytes, not 134"},
        // The header is a letter or a blank, and zeros: no text in UTF-16 or UTF-32.
        {"a.stl", "m" + binary_stl(2, 84 + 60).substr(1),
         ": error: a binary STL of 2 triangles has 184 bytes, not 144"},
        {"a.stl", " \0m\0"s + binary_stl(2, 84 + 60).substr(4),
         ": error: a binary STL of 2 triangles has 184 bytes, not 144"},
        {"a.stl", binary_stl(0, 84 + 50),
         ": error: a binary STL of 0 triangles has 84 bytes, not 134"},
        {"a.stl", binary_stl(0, 84), ": error: has no triangles: expected at least one"},
        {"a.stl", binary_stl(1, 84 + 50),
         ": error: has no triangles: 1 face has fewer than three different corners"},
        {"a.stl", "solid x facet normal 0 0 1 outer loop vertex 0 0 0", ":1: error: " + no_loop},
        {"a.stl", "solid x\nfacet normal 0 0 1 outer loop\nvertex 0 0 0\n",
         ":3: error: expected \"facet\" or \"outer loop\" at the start of a line, not \"vertex 0 0 "
         "0\""},
        {"a.stl", "solid x\nouter loop\nvertex 0 0 0 vertex 1 0 0\n",
         ":3: error: a vertex is on a line of its own, followed here by \"vertex\""},
    });
    std::string infinite = binary_stl(1, 84 + 50);
    infinite.replace(84 + 12 + 4, 4, "\0\0\x80\xff"s);
    CHECK(mesh_refusal("a.stl", infinite) ==
          "a.stl: error: triangle 0 has a corner that is not a place");
}
