#include "common/course/exercise/hints.hpp"

#include "common/course/build/project.hpp"
#include "common/system/files.hpp"

#include <algorithm>
#include <cctype>
#include <vector>

namespace rt {

std::string hint_text(int stage, int level) {
    std::string text;
    bool inside = false;
    for (const std::string& line :
         lines_of(read_text(project_folder / step_path(stage, "hints.md")))) {
        if (line.starts_with("## "))
            inside = line == "## " + std::to_string(level);
        else if (inside)
            text += line + "\n";
    }
    const std::size_t first = text.find_first_not_of('\n');
    return first == std::string::npos ? "" : text.substr(first);
}

int hint_count(int stage) {
    int count = 0;
    while (count < hint_levels && !hint_text(stage, count + 1).empty()) ++count;
    return count;
}

namespace {

/// The words that stand before ": ", or before ", ", at the start of a paragraph.
std::string label_of(const std::string& line) {
    return line.substr(0, line.find_first_of(":,"));
}

/// The functions that the first level explains, each in a paragraph that begins with its name.
std::vector<std::string> labels_of(int stage) {
    std::vector<std::string> labels;
    std::string before;
    for (const std::string& line : lines_of(hint_text(stage, 1))) {
        const std::string label = label_of(line);
        if (before.empty() && line.compare(label.size(), 2, ": ") == 0) labels.push_back(label);
        before = line;
    }
    return labels;
}

}  // namespace

bool names(const std::string& part, const std::string& label) {
    const auto is_letter = [&part](std::size_t i) {
        return i < part.size() &&
               (std::isalpha(static_cast<unsigned char>(part[i])) != 0 || part[i] == '_');
    };
    for (std::size_t at = part.find(label); at != std::string::npos; at = part.find(label, at + 1))
        if ((at == 0 || !is_letter(at - 1)) && !is_letter(at + label.size())) return true;
    return false;
}

std::string hint_text(int stage, int level, const std::string& part) {
    const std::string whole = hint_text(stage, level);
    const std::vector<std::string> labels = labels_of(stage);
    std::string text;
    std::string before;
    bool inside = false;
    for (const std::string& line : lines_of(whole)) {
        if (before.empty() && std::ranges::find(labels, label_of(line)) != labels.end())
            inside = names(part, label_of(line));
        if (inside) text += line + "\n";
        before = line;
    }
    while (text.size() > 1 && text[text.size() - 2] == '\n') text.pop_back();
    return text.empty() ? whole : text;
}

}  // namespace rt
