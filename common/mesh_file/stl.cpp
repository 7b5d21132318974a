#include "common/mesh_file/mesh_builder.hpp"
#include "common/mesh_file/mesh_formats.hpp"
#include "common/mesh_file/mesh_lines.hpp"
#include "common/system/escaping.hpp"
#include "common/system/input_file.hpp"
#include "common/system/text.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <numbers>

namespace rt {

namespace {

/// The layout of a binary file: 80 arbitrary bytes, the number of triangles, then 50 bytes for
/// each: twelve floats, of which the first three are a normal, and two bytes more.
constexpr std::size_t header_size = 84;
constexpr std::size_t triangle_size = 50;

/// Edges stay sharp beyond this angle between the normals of their faces, in radians.
constexpr double crease_angle = 40 * std::numbers::pi / 180;

std::uint32_t little_endian(std::string_view content, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 4; i-- > 0;)
        value = value << 8 | static_cast<unsigned char>(content[at + i]);
    return value;
}

/// Adds the facets to the builder, with one vertex for all corners in one place.
class Facets {
public:
    explicit Facets(MeshBuilder& builder) : builder_(builder) { builder.set_facets(crease_angle); }

    void add(const std::array<glm::dvec3, 3>& corners) {
        std::array<std::uint32_t, 3> face;
        for (std::size_t i = 0; i < 3; ++i) {
            face[i] = welder_.place(corners[i]);
            if (face[i] == builder_.vertex_count()) builder_.add_vertex(corners[i]);
        }
        builder_.add_face(face);
    }

private:
    MeshBuilder& builder_;
    Welder welder_;
};

void read_binary(std::string_view content, std::size_t triangles, const std::string& file,
                 MeshBuilder& builder) {
    builder.reserve(triangles / 2 + 2, triangles);
    Facets facets(builder);
    for (std::size_t i = 0; i < triangles; ++i) {
        const std::size_t at = header_size + i * triangle_size + 12;
        std::array<glm::dvec3, 3> corners;
        for (std::size_t k = 0; k < 9; ++k) {
            const double value = std::bit_cast<float>(little_endian(content, at + 4 * k));
            if (!std::isfinite(value)) {
                throw InputError(
                    {file}, "triangle " + std::to_string(i) + " has a corner that is not a place");
            }
            corners[k / 3][glm::length_t(k % 3)] = value;
        }
        facets.add(corners);
    }
}

/// A comment of other programs; one that begins with '#' is blank.
bool is_comment(std::string_view line) {
    return line.starts_with("//") || line.starts_with(';');
}

/// The keyword of a line in lower case, without the blank of "end solid".
std::string take_keyword(std::string_view& line) {
    std::string keyword = lower_case(std::string(take_word(line).substr(0, 16)));
    if (keyword == "end") keyword += lower_case(std::string(take_word(line).substr(0, 16)));
    return keyword;
}

void read_text(std::string& content, const std::string& file, MeshBuilder& builder) {
    blank_comments(content);
    MeshLines lines(content, file);
    Facets facets(builder);
    std::array<glm::dvec3, 3> corners;
    std::size_t to_come = 0;  // corners
    bool has_facet = false;
    bool has_end = false;
    int after_end = 0;  // a line that is not of a solid
    while (const auto line = lines.next()) {
        if (is_comment(*line)) continue;
        std::string_view rest = *line;
        const std::string keyword = take_keyword(rest);
        if (keyword == "solid" || keyword == "facet" || keyword == "outer") {
            has_end = false;
            after_end = 0;
        }
        if (keyword == "endsolid")
            has_end = true;
        else if (has_end && after_end == 0)
            after_end = lines.number();
        if ((to_come > 0) != (keyword == "vertex")) {
            lines.refuse(std::string("expected ") +
                         (to_come > 0 ? "\"vertex x y z\"" : "\"facet\" or \"outer loop\"") +
                         " at the start of a line, not " + quoted(*line));
        }
        if (keyword == "outer") to_come = 3;
        has_facet = has_facet || to_come > 0;
        if (keyword != "vertex") continue;
        corners[3 - to_come] = take_point(rest, "a vertex", lines);
        require_no_word(rest, "a vertex", lines);
        if (--to_come == 0) facets.add(corners);
    }
    if (to_come > 0) lines.refuse("the file ends within a facet");
    if (!has_facet) lines.refuse("has no triangles: no line begins with \"outer loop\"");
    if (!has_end) builder.warn("has no \"endsolid\" at its end: its last facets may be missing");
    if (after_end > 0) builder.warn("what follows \"endsolid\" is not read", after_end);
}

/// Returns whether a line begins with "solid" or "facet", in any case. Any text may precede it.
bool is_text(const std::string& content) {
    MeshLines lines(content, "");
    while (const auto line = lines.next()) {
        const std::string word = lower_case(std::string(line->substr(0, 5)));
        if (word == "solid" || word == "facet") return true;
    }
    return false;
}

}  // namespace

void read_stl(std::string& content, const std::string& file, MeshBuilder& builder) {
    // The first bytes of a binary file may be "solid" too. But the last of its count is 0, below 16
    // million triangles, and no text has a zero byte.
    const bool has_header = content.size() >= header_size && content[header_size - 1] == '\0';
    if (!has_header) {
        if (is_utf16(content)) throw InputError({file}, text_in_utf16);
        blank_byte_order_mark(content);
        plain_text(content);
        if (is_text(content)) return read_text(content, file, builder);
        std::string_view first = MeshLines(content, file).next().value_or("");
        throw InputError({file}, "is not STL: expected \"solid\" or a binary header, not " +
                                     quoted(take_word(first)));
    }
    const std::size_t count = little_endian(content, 80);
    const std::size_t size = header_size + count * triangle_size;
    if (content.size() != size && is_utf16(content)) throw InputError({file}, text_in_utf16);
    const std::string sizes = "a binary STL of " + std::to_string(count) + " triangles has " +
                              std::to_string(size) + " bytes, not " +
                              std::to_string(content.size());
    if (content.size() < size || (count == 0 && content.size() > size))
        throw InputError({file}, sizes);
    // Some programs write a line end more, or data of their own.
    if (content.size() > size) builder.warn(sizes + ": the rest is not read");
    read_binary(content, count, file, builder);
}

}  // namespace rt
