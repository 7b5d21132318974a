#include "common/mesh_file/off_header.hpp"

#include "common/system/escaping.hpp"

#include <algorithm>
#include <string>

namespace rt {

namespace {

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

}  // namespace

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

}  // namespace rt
