#include "common/mesh_file/checked_mesh.hpp"
#include "common/mesh_file/element_lists.hpp"
#include "common/mesh_file/mesh_lines.hpp"
#include "common/system/escaping.hpp"

#include <algorithm>
#include <utility>

namespace rt {

namespace {

/// Replaces comments with blanks: from '#' to the end of the line.
void blank_comments(std::string& content) {
    for (auto at = content.find('#'); at != std::string::npos; at = content.find('#', at)) {
        const auto end = std::min(content.find('\n', at), content.size());
        std::fill(content.begin() + static_cast<std::ptrdiff_t>(at),
                  content.begin() + static_cast<std::ptrdiff_t>(end), ' ');
    }
}

bool take_prefix(std::string_view& word, std::string_view prefix) {
    if (!word.starts_with(prefix)) return false;
    word.remove_prefix(prefix.size());
    return true;
}

/// Checks the first word of the file. Returns whether vertices have normals.
bool check_keyword(std::string_view word, std::string_view after, const MeshLines& lines) {
    const std::string_view whole = word;
    take_prefix(word, "ST");
    take_prefix(word, "C");
    const bool has_normals = take_prefix(word, "N");
    if (word == "4OFF" || word == "nOFF" || word == "4nOFF") {
        lines.refuse(quoted(whole) + " is not read: expected vertices of three dimensions");
    }
    if (word != "OFF") lines.refuse("expected OFF, not " + quoted(whole));
    if (take_word(after) == "BINARY") lines.refuse("binary OFF is not read: expected text");
    return has_normals;
}

std::uint64_t take_count(std::string_view& line, const char* what, const MeshLines& lines) {
    const std::string_view word = take_word(line);
    const auto count = whole_number(word);
    if (count && *count >= 0) return static_cast<std::uint64_t>(*count);
    lines.refuse(std::string("expected the number of ") + what + ", not " + quoted(word));
}

}  // namespace

void read_off(std::string content, const std::string& file, MeshImporter& importer) {
    blank_comments(content);
    plain_text(content);
    MeshLines lines(content, file);
    std::string_view line = lines.next().value_or("");
    const std::string_view keyword = take_word(line);
    const bool has_normals = check_keyword(keyword, line, lines);

    // The numbers of vertices, faces and edges (ignored) may be on the line of the keyword.
    if (count_words(line) == 0) line = lines.next().value_or("");
    MeshLists lists;
    lists.vertices = take_count(line, "vertices", lines);
    lists.faces = take_count(line, "faces", lines);
    static_cast<void>(take_word(line));
    const std::string_view next = take_word(line);
    if (!next.empty()) {
        lines.refuse(
            "expected the numbers of vertices, faces and edges, and then one vertex a line, not " +
            quoted(next));
    }

    lists.columns = {0, 1, 2};
    if (has_normals) lists.columns = {0, 1, 2, 3, 4, 5};
    read_lists(lines, std::move(lists), importer);
}

}  // namespace rt
