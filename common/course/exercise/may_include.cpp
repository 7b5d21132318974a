#include "common/course/exercise/may_include.hpp"

#include "common/stages/stages.hpp"

#include <sstream>

namespace rt {

namespace {

/// True if a line starts a comment that continues on the next.
bool opens_comment(const std::string& line) {
    const std::size_t start = line.rfind("/*");
    return start != std::string::npos && line.find("*/", start + 2) == std::string::npos &&
           line.find("//") > start && line.find('"') > start;
}

/// The header of a line like `# include "common/geometry/ray.hpp"`, in quotes or in brackets; or
/// nothing.
std::string included_by(const std::string& line) {
    const auto skip = [&line](std::size_t from) { return line.find_first_not_of(" \t", from); };
    const std::size_t hash = skip(0);
    if (hash == std::string::npos || line[hash] != '#') return "";
    const std::size_t word = skip(hash + 1);
    if (word == std::string::npos || line.compare(word, 7, "include") != 0) return "";
    const std::size_t start = skip(word + 7);
    if (start == std::string::npos || (line[start] != '"' && line[start] != '<')) return "";
    const std::size_t end = line.find(line[start] == '<' ? '>' : '"', start + 1);
    return end == std::string::npos ? "" : line.substr(start + 1, end - start - 1);
}

/// True if a line for `whose`, such as "trace:step04_plane" for each main.cpp from that stage on,
/// is for the file.
bool is_for(const std::string& whose, GradedFile graded) {
    if (const auto first = after("trace:", whose))
        return graded.is_trace && *first <= stage_name(graded.stage);
    return whose == "all" || (!graded.is_trace && whose == stage_name(graded.stage));
}

/// The lines of steps/may_include.txt that are for the file.
std::vector<fs::path> listed(const fs::path& project, GradedFile graded) {
    std::vector<fs::path> headers;
    for (const std::string& line : lines_of(read_text(project / "steps/may_include.txt"))) {
        std::istringstream words(line);
        std::string whose;
        std::string header;
        words >> whose >> header;
        if (is_for(whose, graded)) headers.emplace_back(header);
    }
    return headers;
}

}  // namespace

std::vector<Include> includes_of(const fs::path& file) {
    std::vector<Include> all;
    int number = 0;
    bool in_comment = false;
    for (const std::string& line : lines_of(read_text(file))) {
        ++number;
        if (in_comment) {
            in_comment = line.find("*/") == std::string::npos;
            continue;
        }
        in_comment = opens_comment(line);
        const std::string header = included_by(line);
        if (!header.empty()) all.push_back({.line = number, .header = header});
    }
    return all;
}

fs::path stage_header(int stage) {
    return fs::path("steps") / name_of(stage) / (topic_of(stage) + ".hpp");
}

std::set<fs::path> allowed_headers(const fs::path& project, GradedFile graded) {
    std::vector<fs::path> wanted = listed(project, graded);
    for (int stage = graded.is_trace ? 1 : graded.stage; stage <= graded.stage; ++stage)
        wanted.push_back(stage_header(stage));
    std::set<fs::path> allowed;
    while (!wanted.empty()) {
        const fs::path header = wanted.back();
        wanted.pop_back();
        if (!allowed.insert(header).second) continue;
        for (const Include& each : includes_of(project / header))
            if (fs::is_regular_file(project / each.header)) wanted.emplace_back(each.header);
    }
    return allowed;
}

std::vector<Include> refused_includes(const fs::path& project, GradedFile graded,
                                      const fs::path& file) {
    const std::set<fs::path> allowed = allowed_headers(project, graded);
    std::vector<Include> refused;
    for (Include& each : includes_of(file)) {
        const bool is_ours = fs::is_regular_file(project / each.header) ||
                             fs::is_regular_file(file.parent_path() / each.header);
        if (is_ours && allowed.count(fs::path(each.header).lexically_normal()) == 0)
            refused.push_back(std::move(each));
    }
    return refused;
}

}  // namespace rt
