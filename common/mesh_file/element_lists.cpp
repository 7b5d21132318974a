#include "common/mesh_file/element_lists.hpp"

#include "common/mesh_file/mesh_file.hpp"
#include "common/system/escaping.hpp"

#include <algorithm>
#include <array>
#include <string>

namespace rt {

namespace {

/// Returns the next line of a list. Throws InputError at the end of the file.
std::string_view next_item(MeshLines& lines, const char* what, std::uint64_t index,
                           std::uint64_t count) {
    if (const auto line = lines.next()) return *line;
    lines.refuse("the file ends after " + std::to_string(index) + " of " + std::to_string(count) +
                 " " + what);
}

void check_word_count(std::size_t words, const MeshLists& lists, const MeshLines& lines) {
    if (words == lists.words_a_vertex) return;
    lines.refuse("a vertex has " + std::to_string(lists.words_a_vertex) +
                 " numbers here, on a line of its own, not " + std::to_string(words));
}

/// Removes the number of corners from the line and returns it.
int take_corner_count(std::string_view& line, const MeshLines& lines) {
    std::string_view before = line;
    const auto corners = take_whole_number(line);
    if (!corners || *corners < 0) {
        lines.refuse("a face begins with the number of its corners, not " +
                     quoted(take_word(before)));
    }
    if (*corners > most_corners) {
        lines.refuse("a face of " + std::to_string(*corners) + " corners: expected at most " +
                     std::to_string(most_corners));
    }
    return static_cast<int>(*corners);
}

[[noreturn]] void refuse_number(std::string_view word, const MeshLines& lines) {
    lines.refuse("expected a number in the range of float, or an existing vertex, not " +
                 quoted(word));
}

void read_vertex(const std::string_view line, const MeshLines& lines, const MeshLists& lists,
                 bool has_normals, MeshImporter& importer) {
    std::array<float, 6> numbers{};
    std::string_view rest = line;
    for (const int column : lists.columns) {
        if (column < 0) {
            if (take_word(rest).empty()) check_word_count(count_words(line), lists, lines);
            continue;
        }
        const auto number = take_float(rest);
        if (!number) {
            check_word_count(count_words(line), lists, lines);
            refuse_number(take_word(rest), lines);
        }
        numbers[std::size_t(column)] = *number;
    }
    check_word_count(lists.columns.size() + count_words(rest), lists, lines);
    const auto vertex = importer.add_vertex({numbers[0], numbers[1], numbers[2]});
    if (has_normals)
        importer.set_normal(vertex, OpenMesh::Vec3f(numbers[3], numbers[4], numbers[5]));
}

void read_face(std::string_view line, const MeshLines& lines, std::uint64_t vertices,
               MeshImporter& importer, MeshImporter::VHandles& face) {
    const int corners = take_corner_count(line, lines);
    face.clear();
    for (int i = 0; i < corners; ++i) {
        const auto vertex = take_whole_number(line);
        if (!vertex) {
            const std::string_view word = take_word(line);
            if (!word.empty()) refuse_number(word, lines);
            lines.refuse("a face of " + std::to_string(corners) + " corners ends after " +
                         std::to_string(i));
        }
        if (*vertex < 0 || static_cast<std::uint64_t>(*vertex) >= vertices)
            lines.refuse(no_such_vertex(*vertex, vertices));
        face.emplace_back(static_cast<int>(*vertex));
    }
    importer.add_face(face);
}

}  // namespace

void read_lists(MeshLines& lines, MeshLists lists, MeshImporter& importer) {
    // The file may promise more than it has: a line has at least six bytes, "0 0 0" and its end.
    const std::uint64_t most = lines.left() / 6 + 1;
    importer.reserve(unsigned(std::min(lists.vertices, most)), 0,
                     unsigned(std::min(lists.faces, most)));
    bool has_normals = false;
    for (std::uint64_t i = 0; i < lists.vertices; ++i) {
        const std::string_view line = next_item(lines, "vertices", i, lists.vertices);
        if (i == 0) {
            if (lists.words_a_vertex == 0)
                lists.words_a_vertex = std::max<std::size_t>(count_words(line), 3);
            if (lists.words_a_vertex < lists.columns.size()) lists.columns.resize(3);
            has_normals = std::count(lists.columns.begin(), lists.columns.end(), 3) > 0;
        }
        read_vertex(line, lines, lists, has_normals, importer);
    }
    MeshImporter::VHandles face;
    for (std::uint64_t i = 0; i < lists.faces; ++i)
        read_face(next_item(lines, "faces", i, lists.faces), lines, lists.vertices, importer, face);
}

}  // namespace rt
