#include "common/mesh_file/mesh_formats.hpp"
#include "common/mesh_file/mesh_lines.hpp"
#include "common/mesh_file/ply_header.hpp"
#include "common/mesh_file/ply_items.hpp"
#include "common/system/escaping.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace rt {

namespace {

constexpr std::array<std::string_view, 6> coordinates = {"x", "y", "z", "nx", "ny", "nz"};

bool is_corners(const PlyProperty& p) {
    return p.name == "vertex_indices" || p.name == "vertex_index";
}

std::ptrdiff_t count_of(const PlyElement& element, std::string_view property) {
    return std::ranges::count(element.properties, property, &PlyProperty::name);
}

bool has_normals(const PlyElement& vertex) {
    return count_of(vertex, "nx") + count_of(vertex, "ny") + count_of(vertex, "nz") == 3;
}

void check_vertex(const PlyElement& vertex, const std::string& file) {
    for (const std::string_view name : coordinates) {
        const std::ptrdiff_t count = count_of(vertex, name);
        if (count == 1 || (count == 0 && name[0] == 'n')) continue;
        throw InputError({file, vertex.line}, "a vertex has " + std::to_string(count) +
                                                  " properties " + std::string(name) +
                                                  ": expected one");
    }
    for (const PlyProperty& p : vertex.properties) {
        if (!p.length || std::ranges::find(coordinates, p.name) == coordinates.end()) continue;
        throw InputError({file, p.line}, "a vertex's " + p.name + " is a list: expected a number");
    }
}

/// Checks an element of faces or of strips.
void check_corners(const PlyElement& face, const std::string& file) {
    const std::ptrdiff_t count = std::ranges::count_if(face.properties, is_corners);
    if (count != 1) {
        throw InputError({file, face.line}, "a " + face.name + " has " + std::to_string(count) +
                                                " lists vertex_indices: expected one");
    }
    const PlyProperty& corners = *std::ranges::find_if(face.properties, is_corners);
    if (corners.length && !corners.type.is_float) return;
    throw InputError({file, corners.line},
                     rt::quoted(corners.name) + " must be a list of whole numbers");
}

bool has_faces(const PlyElement& element) {
    return element.name == "face" || element.name == "tristrips";
}

void check_header(const PlyHeader& header, const std::string& file) {
    if (header.format != "ascii" && header.format != "binary_little_endian" &&
        header.format != "binary_big_endian") {
        throw InputError({file},
                         "expected the format ascii, binary_little_endian or binary_big_endian, "
                         "not " +
                             rt::quoted(header.format));
    }
    const auto& elements = header.elements;
    const auto vertices = std::ranges::count(elements, "vertex", &PlyElement::name);
    if (vertices != 1) {
        throw InputError({file},
                         "has " + std::to_string(vertices) + " elements vertex: expected one");
    }
    if (std::ranges::none_of(elements, has_faces))
        throw InputError({file}, "has no element face, and so no surface: points cannot be drawn");
    for (const PlyElement& element : elements) {
        for (const PlyProperty& p : element.properties) {
            if (!p.length || !p.length->is_float) continue;
            throw InputError({file, p.line}, "the length of the list " + rt::quoted(p.name) +
                                                 " must be a whole number: save it without");
        }
        if (element.name == "vertex") check_vertex(element, file);
        if (has_faces(element)) check_corners(element, file);
    }
}

/// Throws InputError for a count that is too large for the bytes after the header, before memory is
/// allocated for it.
void check_size(const PlyHeader& header, std::uint64_t bytes, const std::string& file) {
    for (const PlyElement& element : header.elements) {
        std::uint64_t least = 0;
        for (const PlyProperty& p : element.properties)
            least += p.length ? p.length->size : p.type.size;
        if (least == 0) continue;
        if (element.count > bytes / least) {
            const std::string what = element.name == "vertex" ? "vertices"
                                     : element.name == "face"
                                         ? "faces"
                                         : "items of " + rt::quoted(element.name);
            throw InputError({file, element.line}, "the file ends too early for " +
                                                       std::to_string(element.count) + " " + what);
        }
        bytes -= element.count * least;
    }
}

/// Reads the elements of a file, in which faces may precede the vertices.
template <class Items>
class PlyReader {
public:
    PlyReader(const PlyHeader& header, MeshBuilder& builder) : header_(header), builder_(builder) {}

    void read(Items items) {
        bool has_vertices = false;
        std::vector<std::pair<const PlyElement*, Items>> postponed;
        for (const PlyElement& element : header_.elements) {
            if (element.name == "vertex") {
                read_vertices(items, element);
                has_vertices = true;
            } else if (!has_faces(element)) {
                items.skip_all(element);
            } else if (has_vertices) {
                read_faces(items, element);
            } else {
                postponed.emplace_back(&element, items);
                items.skip_all(element);
            }
        }
        for (auto& [element, at] : postponed) read_faces(at, *element);
    }

private:
    void read_vertices(Items& items, const PlyElement& vertex) {
        builder_.reserve(std::min(vertex.count, items.most_items()), 0);
        const bool with_normals = has_normals(vertex);
        std::vector<std::size_t> columns;  // the coordinate of each property, or more than the last
        for (const PlyProperty& p : vertex.properties) {
            const auto found = std::ranges::find(coordinates, p.name) - coordinates.begin();
            columns.push_back(found >= 3 && !with_normals ? coordinates.size()
                                                          : std::size_t(found));
        }
        for (std::uint64_t i = 0; i < vertex.count; ++i) {
            items.begin(vertex, i);
            std::array<double, 6> numbers{};
            for (std::size_t k = 0; k < columns.size(); ++k) {
                const PlyProperty& p = vertex.properties[k];
                if (columns[k] < 3) {
                    numbers[columns[k]] = items.number(vertex, p.type);
                } else if (columns[k] < coordinates.size()) {
                    numbers[columns[k]] = items.number_or_nan(vertex, p.type);
                } else {
                    skip_property(items, vertex, p);
                }
            }
            items.end(vertex);
            builder_.add_vertex({numbers[0], numbers[1], numbers[2]});
            if (with_normals)
                builder_.with_normal(std::uint32_t(i), {numbers[3], numbers[4], numbers[5]});
        }
    }

    void read_faces(Items& items, const PlyElement& element) {
        if (element.name == "face")
            builder_.reserve(0, std::min(element.count, items.most_items()));
        for (std::uint64_t i = 0; i < element.count; ++i) {
            items.begin(element, i);
            for (const PlyProperty& p : element.properties) {
                if (!is_corners(p)) {
                    skip_property(items, element, p);
                } else if (element.name == "face") {
                    read_face(items, element, p);
                } else {
                    read_strip(items, element, p);
                }
                // A line may end after the corners.
                if (Items::are_lines && is_corners(p)) break;
            }
        }
    }

    std::uint32_t existing(Items& items, std::int64_t vertex) const {
        const std::size_t count = builder_.vertex_count();
        if (vertex < 0 || std::uint64_t(vertex) >= count)
            items.refuse(no_such_vertex(vertex, count));
        return std::uint32_t(vertex);
    }

    void read_face(Items& items, const PlyElement& element, const PlyProperty& p) {
        const std::int64_t corners = items.whole_number(element, *p.length);
        if (corners < 0 || corners > most_corners) {
            items.refuse("a face of " + std::to_string(corners) + " corners: expected at most " +
                         std::to_string(most_corners));
        }
        face_.clear();
        for (std::int64_t k = 0; k < corners; ++k)
            face_.push_back(existing(items, items.whole_number(element, p.type)));
        builder_.add_face(face_);
    }

    /// Each corner of a strip makes a triangle with the two before it, and every second triangle is
    /// turned; −1 begins a new strip.
    void read_strip(Items& items, const PlyElement& element, const PlyProperty& p) {
        const std::int64_t corners = items.whole_number(element, *p.length);
        face_.clear();
        bool is_turned = false;
        for (std::int64_t k = 0; k < corners; ++k) {
            const std::int64_t vertex = items.whole_number(element, p.type);
            if (vertex == -1) {
                face_.clear();
                is_turned = false;
                continue;
            }
            face_.push_back(existing(items, vertex));
            if (face_.size() < 3) continue;
            const std::uint32_t a = face_[0];
            const std::uint32_t b = face_[1];
            const std::uint32_t c = face_[2];
            // Strips repeat corners where they turn.
            if (a != b && b != c && c != a)
                builder_.add_face(is_turned ? std::array{b, a, c} : std::array{a, b, c});
            is_turned = !is_turned;
            face_.erase(face_.begin());
        }
    }

    const PlyHeader& header_;
    MeshBuilder& builder_;
    std::vector<std::uint32_t> face_;
};

}  // namespace

void read_ply(std::string& content, const std::string& file, MeshBuilder& builder) {
    blank_byte_order_mark(content);
    const bool has_cr_lines = content.find("\rformat ascii") < content.find('\n');
    if (has_cr_lines) plain_text(content);
    MeshLines lines(content, file);
    const PlyHeader header = take_ply_header(lines);
    check_header(header, file);
    if (header.format == "ascii") {
        plain_text(content);
        PlyReader<PlyText>(header, builder).read(PlyText(lines));
        return;
    }
    check_size(header, lines.left(), file);
    const auto order =
        header.format == "binary_big_endian" ? std::endian::big : std::endian::little;
    const auto body = std::string_view(content).substr(lines.position());
    PlyReader<PlyBytes>(header, builder).read(PlyBytes(body, order, file));
}

}  // namespace rt
