#include "common/mesh_file/mesh_formats.hpp"
#include "common/mesh_file/mesh_lines.hpp"
#include "common/mesh_file/ply_header.hpp"
#include "common/mesh_file/ply_items.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace rt {

namespace {

bool has_normals(const PlyElement& vertex) {
    return std::ranges::count_if(vertex.properties, [](const PlyProperty& p) {
               return p.name == "nx" || p.name == "ny" || p.name == "nz";
           }) == 3;
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
        items.warn_of_rest(builder_);
    }

private:
    void read_vertices(Items& items, const PlyElement& vertex) {
        builder_.reserve(std::min(vertex.count, items.most_items()), 0);
        const bool with_normals = has_normals(vertex);
        std::vector<std::size_t> columns;  // the coordinate of each property, or more than the last
        for (const PlyProperty& p : vertex.properties) {
            const auto found = std::ranges::find(ply_coordinates, p.name) - ply_coordinates.begin();
            columns.push_back(found >= 3 && !with_normals ? ply_coordinates.size()
                                                          : std::size_t(found));
        }
        for (std::uint64_t i = 0; i < vertex.count; ++i) {
            items.begin(vertex, i);
            std::array<double, 6> numbers{};
            for (std::size_t k = 0; k < columns.size(); ++k) {
                const PlyProperty& p = vertex.properties[k];
                if (columns[k] < 3) {
                    numbers[columns[k]] = items.number(vertex, p.type);
                } else if (columns[k] < ply_coordinates.size()) {
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

/// Ends the lines of a header in LF that ends them in CR alone; and those of a text after it.
void end_header_lines_in_lf(std::string& content) {
    constexpr std::string_view last = "\rend_header\r";
    const std::size_t end = content.find(last);
    if (end == std::string::npos || content.find('\n') < end) return;
    if (content.find("\rformat ascii") < end) return plain_text(content);
    std::replace(content.begin(), content.begin() + std::ptrdiff_t(end + last.size()), '\r', '\n');
}

}  // namespace

void read_ply(std::string& content, const std::string& file, MeshBuilder& builder) {
    blank_byte_order_mark(content);
    end_header_lines_in_lf(content);
    MeshLines lines(content, file);
    PlyHeader header = take_ply_header(lines);
    name_corners(header, builder);
    check_ply_header(header, file);
    if (header.format == "ascii") {
        plain_text(content);
        blank_comments(content, lines.position());
        PlyReader<PlyText>(header, builder).read(PlyText(lines));
        return;
    }
    check_ply_size(header, lines.left(), file);
    const auto order =
        header.format == "binary_big_endian" ? std::endian::big : std::endian::little;
    const auto body = std::string_view(content).substr(lines.position());
    PlyReader<PlyBytes>(header, builder).read(PlyBytes(body, order, file));
}

}  // namespace rt
