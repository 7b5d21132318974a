#include "common/mesh_formats/lists.hpp"

#include "common/mesh_file.hpp"

#include <algorithm>

namespace rt {

namespace {

/// The next line of a list.
std::string_view next_item(MeshLines& lines, const char* what, std::uint64_t index,
                           std::uint64_t count) {
    if (const auto line = lines.next()) return *line;
    lines.refuse("the file ends after " + std::to_string(index) + " of " + std::to_string(count) +
                 " " + what);
}

void check_vertex(std::string_view line, const MeshLines& lines, MeshLists& lists) {
    const std::size_t words = count_words(line);
    if (lists.words_a_vertex == 0) lists.words_a_vertex = std::max<std::size_t>(words, 3);
    if (words == lists.words_a_vertex) return;
    lines.refuse("a vertex has " + std::to_string(lists.words_a_vertex) +
                 " numbers here, on a line of its own, not " + std::to_string(words));
}

/// What follows the corners.
std::string_view check_face(std::string_view line, const MeshLines& lines) {
    const std::string_view word = take_word(line);
    const auto corners = whole_number(word);
    if (!corners || *corners < 0) {
        lines.refuse("a face begins with the number of its corners, not " + quoted_word(word));
    }
    if (*corners > most_corners) {
        lines.refuse("a face of " + std::to_string(*corners) + " corners: expected at most " +
                     std::to_string(most_corners));
    }
    for (std::int64_t i = 0; i < *corners; ++i) {
        if (!take_word(line).empty()) continue;
        lines.refuse("a face of " + std::to_string(*corners) + " corners ends after " +
                     std::to_string(i));
    }
    return line;
}

}  // namespace

void check_lists(std::string& content, MeshLines& lines, MeshLists& lists) {
    for (std::uint64_t i = 0; i < lists.vertices; ++i) {
        check_vertex(next_item(lines, "vertices", i, lists.vertices), lines, lists);
    }
    for (std::uint64_t i = 0; i < lists.faces; ++i) {
        const auto rest = check_face(next_item(lines, "faces", i, lists.faces), lines);
        std::fill_n(content.begin() + (rest.data() - content.data()), rest.size(), ' ');
    }
}

}  // namespace rt
