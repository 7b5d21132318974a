#include "common/mesh_file/checked_mesh.hpp"
#include "common/mesh_file/mesh_file.hpp"
#include "common/mesh_file/mesh_lines.hpp"
#include "common/mesh_file/open_mesh.hpp"
#include "common/system/escaping.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace rt {

namespace {

/// Vertices or normals: their count so far, and the largest index in a face.
struct Numbered {
    const char* what;
    std::int64_t count = 0;
    std::int64_t largest = 0;
    int line_of_largest = 0;

    /// Checks an index in a face: from 1, or negative to count back from the last. Returns the
    /// index from 1.
    std::int64_t check(std::string_view word, const MeshLines& lines) {
        const auto number = whole_number(word);
        if (!number || *number == 0) {
            lines.refuse(std::string("a corner's ") + what +
                         " must be a whole number other than 0, not " + quoted(word));
        }
        if (*number < -count) {
            lines.refuse(std::string("a corner's ") + what + " must be one of the " +
                         std::to_string(count) + " before it, not " + quoted(word));
        }
        if (*number > largest) {
            largest = *number;
            line_of_largest = lines.number();
        }
        return *number < 0 ? count + 1 + *number : *number;
    }

    void check_largest(const std::string& file) const {
        if (largest <= count) return;
        const std::string given = ", not \"" + std::to_string(largest) + "\"";
        const std::string named = std::string("a corner's ") + what;
        if (count == 0)
            throw InputError({file, line_of_largest},
                             named + " must be in the file, which has none" + given);
        throw InputError({file, line_of_largest},
                         named + " must be from 1 to " + std::to_string(count) + given);
    }
};

/// Checks a corner "vertex", "vertex/texture", "vertex//normal" or "vertex/texture/normal". Returns
/// the vertex.
std::int64_t check_corner(std::string_view word, Numbered& vertices, Numbered& normals,
                          const MeshLines& lines) {
    const std::size_t first = word.find('/');
    const std::int64_t vertex = vertices.check(word.substr(0, first), lines);
    if (first == std::string_view::npos) return vertex;
    const std::string_view rest = word.substr(first + 1);
    const std::size_t second = rest.find('/');
    const std::string_view texture = rest.substr(0, second);
    const std::string_view normal =
        second == std::string_view::npos ? std::string_view() : rest.substr(second + 1);
    if (!texture.empty() && !whole_number(texture)) {
        lines.refuse("a corner is vertex/texture/normal, each a whole number, not " + quoted(word));
    }
    if (!normal.empty()) normals.check(normal, lines);
    return vertex;
}

/// Checks a face. Returns whether it has three different vertices.
bool check_face(std::string_view line, Numbered& vertices, Numbered& normals,
                const MeshLines& lines) {
    int corners = 0;
    std::array<std::int64_t, 3> different{};
    std::size_t found = 0;
    for (auto word = take_word(line); !word.empty(); word = take_word(line)) {
        const std::int64_t vertex = check_corner(word, vertices, normals, lines);
        const auto end = different.begin() + std::ptrdiff_t(found);
        if (found < different.size() && std::find(different.begin(), end, vertex) == end)
            different[found++] = vertex;
        ++corners;
    }
    if (corners >= 3 && corners <= most_corners) return found == different.size();
    lines.refuse("a face of " + std::to_string(corners) + " corners: expected 3 to " +
                 std::to_string(most_corners));
}

/// Joins each line that ends in a backslash, outside of a comment, with the next one. The line ends
/// that this removes follow the joined line, so that all lines keep their numbers.
void join_continued_lines(std::string& content) {
    if (content.find('\\') == std::string::npos) return;
    std::string joined;
    joined.reserve(content.size());
    std::size_t removed = 0;
    for (std::string_view rest = content; !rest.empty();) {
        const std::string_view line = rest.substr(0, rest.find('\n'));
        rest.remove_prefix(line.size() + 1);
        const std::size_t last = line.find_last_not_of(" \t\r");
        if (last != std::string_view::npos && line[last] == '\\' && !rest.empty() &&
            line.find('#') == std::string_view::npos) {
            joined.append(line.substr(0, last)).append(1, ' ');
            ++removed;
        } else {
            joined.append(line).append(1 + removed, '\n');
            removed = 0;
        }
    }
    content = std::move(joined);
}

}  // namespace

void read_obj(std::string content, const std::string& file, MeshImporter& importer) {
    plain_text(content);
    join_continued_lines(content);
    MeshLines lines(content, file);
    Numbered vertices = {.what = "vertex"};
    Numbered normals = {.what = "normal"};
    while (const auto line = lines.next()) {
        const std::size_t begin = static_cast<std::size_t>(line->data() - content.data());
        const std::size_t comment = std::min(line->find('#'), line->size());
        std::fill_n(content.begin() + std::ptrdiff_t(begin + comment), line->size() - comment, ' ');
        std::string_view rest = line->substr(0, comment);
        const std::string_view keyword = take_word(rest);
        if (keyword == "v") {
            require_three_numbers(rest, "a vertex", lines);
            require_no_word(rest, "a vertex", lines);
            ++vertices.count;
        } else if (keyword == "vn") {
            require_three_numbers(rest, "a normal", lines);
            require_no_word(rest, "a normal", lines);
            ++normals.count;
        } else if (keyword == "f") {
            // OpenMesh leaves it out in silence.
            if (!check_face(rest, vertices, normals, lines)) importer.leave_out_faces(1);
        } else {
            // Turned into a comment: OpenMesh would open the file that a mtllib names.
            content[begin] = '#';
        }
    }
    vertices.check_largest(file);
    normals.check_largest(file);
    read_checked({.content = std::move(content), .reader = "obj"}, file, importer);
}

}  // namespace rt
