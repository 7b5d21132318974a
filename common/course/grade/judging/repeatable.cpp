#include "common/course/grade/judging/repeatable.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace rt::grade {

namespace {

bool is_of_name(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0;
}

/// Replaces each path that ends in `start`, six letters or digits, and `end`. Written by hand:
/// std::regex overflows the stack on the very long lines of hostile files.
void shorten_names(std::string& text, const std::string& start, const std::string& end,
                   const std::string& by) {
    constexpr std::size_t letters = 6;
    for (std::size_t at = 0; (at = text.find(start, at)) != std::string::npos; ++at) {
        const std::size_t name = at + start.size();
        if (text.compare(std::min(name + letters, text.size()), end.size(), end) != 0 ||
            !std::all_of(text.begin() + long(name), text.begin() + long(name + letters),
                         is_of_name))
            continue;
        if (at > 0 && is_of_name(text[at - 1])) continue;
        std::size_t first = at;
        while (first > 0 && (is_of_name(text[first - 1]) ||
                             std::string_view("/._-").find(text[first - 1]) != std::string::npos))
            --first;
        text.replace(first, name + letters + end.size() - first, by);
        at = first;
    }
}

/// A line of the stack of a compiler that crashed: "0x7f21c0a0 main".
bool is_frame(const std::string& line) {
    return line.starts_with("0x") && line.size() > 2 &&
           std::isxdigit(static_cast<unsigned char>(line[2])) != 0;
}

/// mold's errors, sorted: each is a line and the lines after it that start with ">>>".
std::string sorted_errors(const std::string& words) {
    std::vector<std::string> occludes;
    bool is_error = false;
    std::string before;
    std::string after;
    for (const std::string& line : lines_of(words)) {
        const bool starts = line.starts_with("mold: error: ");
        if (starts)
            occludes.push_back(line + "\n");
        else if (is_error && line.starts_with(">>>"))
            occludes.back() += line + "\n";
        else
            (occludes.empty() ? before : after) += line + "\n";
        is_error = starts || (is_error && line.starts_with(">>>"));
    }
    if (occludes.empty()) return words;
    std::ranges::sort(occludes);
    for (const std::string& block : occludes) before += block;
    return before + after;
}

}  // namespace

std::string repeatable(std::string words, const std::vector<fs::path>& folders) {
    for (const fs::path& folder : folders) replace_all(words, folder.string() + "/", "");
    // The paths of a TemporaryFolder; and the compiler's temporary files, which keep their folder.
    shorten_names(words, "raysteps.", "/", "");
    for (const char* ending : {".s", ".o", ".out", ".res"})
        shorten_names(words, "cc", ending, std::string("temporary") + ending);
    std::string all;
    for (const std::string& line : lines_of(words))
        if (!is_frame(line)) all += line + "\n";
    return sorted_errors(all);
}

}  // namespace rt::grade
