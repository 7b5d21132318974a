#include "common/course/authoring/mistake_source.hpp"

#include "common/system/input_error.hpp"
#include "common/system/lines.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>

namespace rt {

namespace {

namespace fs = std::filesystem;

using Lines = std::vector<std::string>;

Lines lines_in(const fs::path& file) {
    std::ifstream in(file);
    if (!in) throw InputError({file.generic_string()}, "cannot be read");
    return lines_of({std::istreambuf_iterator<char>(in), {}});
}

std::string joined(const Lines& lines) {
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    return text;
}

bool is_of_a_name(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// The line with another name for the function where it is called or defined.
std::string renamed(const std::string& line, const std::string& function, const std::string& name) {
    std::string text;
    std::size_t from = 0;
    const std::string call = function + "(";
    for (std::size_t at = line.find(call); at != std::string::npos; at = line.find(call, at + 1)) {
        if (at > 0 && is_of_a_name(line[at - 1])) continue;
        text += line.substr(from, at - from) + name;
        from = at + function.size();
    }
    return text + line.substr(from);
}

/// The only place of these lines.
std::size_t place_of(const KnownMistake::Change& change, const Lines& lines,
                     const FileLocation& where, const std::string& file) {
    std::optional<std::size_t> place;
    const auto& old = change.old_lines;
    for (auto at = lines.begin();; ++at) {
        at = std::search(at, lines.end(), old.begin(), old.end());
        if (at == lines.end()) break;
        if (place) throw InputError(where, "these lines are in " + file + " twice: add some");
        place = std::size_t(at - lines.begin());
    }
    if (!place) throw InputError(where, "these lines are not in " + file);
    return *place;
}

Lines after_changes(const KnownMistake& mistake, const Lines& lines, const std::string& catalogue) {
    std::map<std::size_t, const KnownMistake::Change*> at;
    for (const KnownMistake::Change& change : mistake.changes) {
        if (change.old_lines.empty()) continue;
        const FileLocation where{catalogue, change.line};
        const std::size_t place = place_of(change, lines, where, mistake.right_answer);
        if (!at.emplace(place, &change).second) throw InputError(where, "these lines change twice");
    }
    Lines changed;
    for (std::size_t i = 0; i < lines.size();) {
        const auto here = at.find(i);
        if (here == at.end()) {
            changed.push_back(lines[i++]);
            continue;
        }
        const auto& [old_lines, new_lines, line] = *here->second;
        changed.insert(changed.end(), new_lines.begin(), new_lines.end());
        const std::size_t end = i + old_lines.size();
        if (const auto next = at.upper_bound(i); next != at.end() && next->first < end)
            throw InputError({catalogue, next->second->line}, "these lines change twice");
        i = end;
    }
    return changed;
}

/// The parts of a source, with the sources that it includes in place.
struct Parts {
    Lines head;  ///< the directives, each once
    Lines body;
};

using Names = std::vector<std::pair<std::string, std::string>>;

void add(Parts& parts, const fs::path& project, const Lines& lines, const Names& names) {
    Names defined;  // #define intersect(...) correct_intersect(__VA_ARGS__)
    for (std::string line : lines) {
        std::istringstream words(line);
        std::string directive, word, name;
        words >> directive >> word >> name;
        const std::size_t open = name.find("(__VA_ARGS__)");
        if (directive == "#define" && word.ends_with("(...)") && open != std::string::npos) {
            defined.emplace_back(word.substr(0, word.size() - 5), name.substr(0, open));
        } else if (directive == "#undef") {
            std::erase_if(defined, [&](const auto& each) { return each.first == word; });
        } else if (directive == "#include" && word.ends_with(".cpp\"")) {
            add(parts, project, lines_in(project / word.substr(1, word.size() - 2)), defined);
        } else if (line.starts_with("#")) {
            if (std::ranges::find(parts.head, line) == parts.head.end()) parts.head.push_back(line);
        } else {
            for (const auto& [function, other] : names) line = renamed(line, function, other);
            parts.body.push_back(line);
        }
    }
}

}  // namespace

std::string without_included_sources(const fs::path& project, const std::string& text) {
    Parts parts;
    add(parts, project, lines_of(text), {});
    return joined(parts.head) + joined(parts.body);
}

std::string source_of(const fs::path& project, const std::string& suite,
                      const KnownMistake& mistake) {
    Lines lines = after_changes(mistake, lines_of(mistake.right_text), catalogue_of(suite));
    for (const std::string& function : mistake.around)
        for (std::string& line : lines)
            if (!line.starts_with('#')) line = renamed(line, function, "correct_" + function);
    const std::string end = "}  // namespace rt";
    for (const auto& change : mistake.changes)
        if (change.old_lines.empty()) {
            auto at = std::find(lines.rbegin(), lines.rend(), end);
            if (at == lines.rend())
                throw InputError({catalogue_of(suite), change.line},
                                 mistake.right_answer + " has no line \"" + end + "\"");
            Lines added = change.new_lines;
            added.push_back("");
            lines.insert(at.base() - 1, added.begin(), added.end());
        }
    return without_included_sources(project, joined(lines));
}

}  // namespace rt
