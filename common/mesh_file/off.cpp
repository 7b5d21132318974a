#include "common/mesh_file/mesh_formats.hpp"

#include "common/mesh_file/mesh_lines.hpp"
#include "common/system/escaping.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace rt {

namespace {

struct OffHeader {
    bool has_normals = false;
    bool colors_first = false;  ///< N before C, as MeshLab writes, and then colors before normals
    bool has_texture = false;
    std::uint64_t vertices = 0;
    std::uint64_t faces = 0;
};

/// The word in capitals, if "off" in it is in lower case. (n is another letter than N.)
std::string in_capitals(std::string_view word) {
    std::string result(word);
    if (word.find("off") == word.npos) return result;
    for (char& c : result)
        if ('a' <= c && c <= 'z') c = char(c - 'a' + 'A');
    return result;
}

/// Removes the keyword from the line: OFF after N, C and ST in any order, each at most once. A
/// number may follow at once.
void take_keyword(std::string_view& line, OffHeader& header, const MeshLines& lines) {
    const std::string_view word = take_word(line);
    const std::string whole = in_capitals(word);
    const std::size_t letters = whole.find("OFF");
    bool has_color = false;
    std::size_t at = 0;
    while (at < std::min(letters, whole.size())) {
        const bool is_texture = whole.compare(at, 2, "ST") == 0;
        bool& flag = is_texture         ? header.has_texture
                     : whole[at] == 'N' ? header.has_normals
                                        : has_color;
        if (flag || (!is_texture && whole[at] != 'N' && whole[at] != 'C')) break;
        header.colors_first = header.colors_first || (whole[at] == 'C' && header.has_normals);
        flag = true;
        at += is_texture ? 2 : 1;
    }
    if (whole.find_first_of("4n") < letters && letters < whole.size())
        lines.refuse(rt::quoted(word) + " is not read: expected vertices of three dimensions");
    std::string_view count = word.substr(std::min(at + 3, word.size()));
    if (at != letters || (!count.empty() && !take_whole_number(count)))
        lines.refuse("expected OFF, not " + rt::quoted(word));
    line = {word.data() + at + 3, std::size_t(line.data() + line.size() - word.data()) - at - 3};
    std::string_view after = line;
    if (take_word(after) == "BINARY") lines.refuse("binary OFF is not read: save it as text");
}

std::uint64_t take_count(std::string_view& line, const char* what, const MeshLines& lines) {
    const std::string_view word = take_word(line);
    const auto count = whole_number(word);
    if (count && *count >= 0) return static_cast<std::uint64_t>(*count);
    lines.refuse(std::string("expected the number of ") + what + ", not " + quoted(word));
}

/// Reads the header, which may be without a keyword. Throws InputError for a variant that is not
/// read.
OffHeader take_off_header(MeshLines& lines) {
    OffHeader header;
    std::string_view line = lines.next().value_or("");
    std::string_view copy = line;
    // A file may begin with its counts.
    if (!take_whole_number(copy)) take_keyword(line, header, lines);
    // The numbers of vertices, faces and edges (ignored) may be on the line of the keyword.
    if (count_words(line) == 0) line = lines.next().value_or("");
    header.vertices = take_count(line, "vertices", lines);
    header.faces = take_count(line, "faces", lines);
    static_cast<void>(take_word(line));
    const std::string_view next = take_word(line);
    if (next.empty()) return header;
    lines.refuse(
        "expected the numbers of vertices, faces and edges, and then one vertex a line, not " +
        quoted(next));
}

/// Returns the next line of a list. Throws InputError at the end of the file.
std::string_view next_item(MeshLines& lines, const char* what, std::uint64_t index,
                           std::uint64_t count) {
    if (const auto line = lines.next()) return *line;
    lines.refuse_end(index, count, what);
}

[[noreturn]] void refuse_number(std::string_view rest, const MeshLines& lines) {
    lines.refuse("expected a number in the range of float, or an existing vertex, not " +
                 quoted(take_word(rest)));
}

/// Removes three words, of which the first vertices have `words`, from the line of a vertex.
glm::dvec3 take_three(std::string_view& rest, std::string_view line, std::size_t words,
                      std::optional<double> (*take)(std::string_view& line),
                      const MeshLines& lines) {
    glm::dvec3 result(0);
    for (int i = 0; i < 3; ++i) {
        const auto number = take(rest);
        if (number) {
            result[i] = *number;
            continue;
        }
        if (const std::size_t count = count_words(line); count < words)
            lines.refuse("a vertex has " + std::to_string(words) +
                         " numbers here, on a line of its own, not " + std::to_string(count));
        refuse_number(rest, lines);
    }
    return result;
}

/// The words of every vertex.
struct VertexWords {
    std::size_t count = 3;
    std::optional<std::size_t>
        before_normal;  ///< between the position and the normal, if it has one
};

/// Returns whether three numbers of about unit length follow that many words.
bool is_unit_after(std::size_t words, std::string_view line) {
    for (std::size_t i = 0; i < words; ++i) static_cast<void>(take_word(line));
    double squares = 0;
    for (int i = 0; i < 3; ++i) {
        const double number = take_number(line).value_or(9);
        squares += number * number;
    }
    return std::abs(squares - 1) < 0.01;
}

/// Geomview has the normal before the color, MeshLab after it. If the first vertex does not say
/// which, the letters do.
VertexWords words_of(std::string_view first, const OffHeader& header) {
    VertexWords words = {.count = std::max<std::size_t>(count_words(first), 3)};
    const std::size_t known = header.has_texture ? 8 : 6;
    if (!header.has_normals || words.count < 6) return words;
    words.before_normal = 0;
    if (words.count <= known) return words;
    const std::size_t color = words.count - known;
    const bool may_be_last = is_unit_after(3 + color, first);
    const bool may_be_first = is_unit_after(3, first);
    if (may_be_last == may_be_first ? header.colors_first : may_be_last)
        words.before_normal = color;
    return words;
}

void read_vertices(const OffHeader& header, MeshLines& lines, MeshBuilder& builder) {
    VertexWords words;
    for (std::uint64_t i = 0; i < header.vertices; ++i) {
        const std::string_view line = next_item(lines, "vertices", i, header.vertices);
        if (i == 0) words = words_of(line, header);
        std::string_view rest = line;
        builder.add_vertex(take_three(rest, line, words.count, take_number, lines));
        std::size_t taken = 3;
        if (words.before_normal) {
            for (std::size_t k = 0; k < *words.before_normal; ++k)
                static_cast<void>(take_word(rest));
            builder.with_normal(std::uint32_t(i),
                                take_three(rest, line, words.count, take_number_or_nan, lines));
            taken += *words.before_normal + 3;
        }
        if (const std::size_t count = taken + count_words(rest); count != words.count)
            lines.refuse("a vertex has " + std::to_string(words.count) +
                         " numbers here, on a line of its own, not " + std::to_string(count));
    }
}

/// Reads a face, which may continue on the next lines; the words after its corners are skipped.
void read_face(std::string_view line, MeshLines& lines, std::uint64_t vertices,
               std::vector<std::uint32_t>& face) {
    std::string_view before = line;
    const auto corners = take_whole_number(line);
    if (!corners || *corners < 0) {
        lines.refuse("a face begins with the number of its corners, not " +
                     rt::quoted(take_word(before)));
    }
    if (*corners > most_corners) {
        lines.refuse("a face of " + std::to_string(*corners) + " corners: expected at most " +
                     std::to_string(most_corners));
    }
    face.clear();
    while (face.size() < std::size_t(*corners)) {
        const auto vertex = take_whole_number(line);
        if (!vertex) {
            if (count_words(line) > 0) refuse_number(line, lines);
            const auto next = lines.next();
            if (!next) {
                lines.refuse("a face of " + std::to_string(*corners) + " corners ends after " +
                             std::to_string(face.size()));
            }
            line = *next;
            continue;
        }
        if (*vertex < 0 || static_cast<std::uint64_t>(*vertex) >= vertices)
            lines.refuse(no_such_vertex(*vertex, vertices));
        face.push_back(static_cast<std::uint32_t>(*vertex));
    }
}

}  // namespace

void read_off(std::string& content, const std::string& file, MeshBuilder& builder) {
    plain_text(content);
    blank_comments(content);
    MeshLines lines(content, file);
    const OffHeader header = take_off_header(lines);
    // The file may promise more than it has: a vertex has at least six bytes, "0 0 0" and its end.
    const std::uint64_t most = lines.left() / 6 + 1;
    builder.reserve(std::min(header.vertices, most), std::min(header.faces, most));
    read_vertices(header, lines, builder);
    std::vector<std::uint32_t> face;
    for (std::uint64_t i = 0; i < header.faces; ++i) {
        read_face(next_item(lines, "faces", i, header.faces), lines, header.vertices, face);
        builder.add_face(face);
    }
    if (lines.next()) {
        builder.warn("the header counts " + std::to_string(header.faces) +
                         (header.faces == 1 ? " face" : " faces") + ": what follows is not read",
                     lines.number());
    }
}

}  // namespace rt
