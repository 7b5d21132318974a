#include "common/mesh_formats/lists.hpp"

#include "common/mesh_file.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>

namespace rt {

namespace {

/// Returns the next line of a list. Throws InputError at the end of the file.
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

/// Removes the number of corners from the line and returns it.
int take_corner_count(std::string_view& line, const MeshLines& lines) {
    const std::string_view word = take_word(line);
    const auto corners = whole_number(word);
    if (!corners || *corners < 0) {
        lines.refuse("a face begins with the number of its corners, not " + quoted_word(word));
    }
    if (*corners > most_corners) {
        lines.refuse("a face of " + std::to_string(*corners) + " corners: expected at most " +
                     std::to_string(most_corners));
    }
    return static_cast<int>(*corners);
}

/// Removes the i-th corner from the line and returns it.
std::string_view take_corner(std::string_view& line, int corners, int i, const MeshLines& lines) {
    const std::string_view word = take_word(line);
    if (!word.empty()) return word;
    lines.refuse("a face of " + std::to_string(corners) + " corners ends after " +
                 std::to_string(i));
}

/// Checks the line of a face, and returns the rest after its corners.
std::string_view check_face(std::string_view line, const MeshLines& lines) {
    const int corners = take_corner_count(line, lines);
    for (int i = 0; i < corners; ++i) static_cast<void>(take_corner(line, corners, i, lines));
    return line;
}

[[noreturn]] void refuse_number(std::string_view word, const MeshLines& lines) {
    lines.refuse("expected a number in the range of float, or an existing vertex, not " +
                 quoted_word(word));
}

template <class Number>
void append(std::string& bytes, Number number) {
    const auto parts = std::bit_cast<std::array<char, sizeof number>>(number);
    bytes.append(parts.data(), parts.size());
}

void append_vertex(std::string& bytes, std::string_view line, const MeshLines& lines,
                   const MeshLists& lists) {
    for (int i = 0; i < (lists.has_normals ? 6 : 3); ++i) {
        const std::string_view word = take_word(line);
        const auto number = float_number(word);
        if (!number) refuse_number(word, lines);
        append(bytes, *number);
    }
}

void append_face(std::string& bytes, std::string_view line, const MeshLines& lines,
                 const MeshLists& lists) {
    const int corners = take_corner_count(line, lines);
    append(bytes, corners);
    for (int i = 0; i < corners; ++i) {
        const std::string_view word = take_corner(line, corners, i, lines);
        const auto vertex = whole_number(word);
        if (!vertex) refuse_number(word, lines);
        if (*vertex < 0 || static_cast<std::uint64_t>(*vertex) >= lists.vertices)
            lines.refuse("vertex " + std::to_string(*vertex) + " is not there: expected 0 to " +
                         std::to_string(lists.vertices - 1));
        append(bytes, static_cast<std::int32_t>(*vertex));
    }
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

std::string binary_lists(MeshLines& lines, MeshLists& lists) {
    std::string bytes;
    bytes.reserve(2 * lines.left());  // in the worst case a digit and a blank become four bytes
    for (std::uint64_t i = 0; i < lists.vertices; ++i) {
        const std::string_view line = next_item(lines, "vertices", i, lists.vertices);
        check_vertex(line, lines, lists);
        lists.has_normals = lists.has_normals && lists.words_a_vertex >= 6;
        append_vertex(bytes, line, lines, lists);
    }
    for (std::uint64_t i = 0; i < lists.faces; ++i)
        append_face(bytes, next_item(lines, "faces", i, lists.faces), lines, lists);
    return bytes;
}

}  // namespace rt
