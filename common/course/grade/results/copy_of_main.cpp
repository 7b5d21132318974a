#include "common/course/grade/results/copy_of_main.hpp"

#include "common/course/grade/results/winnowing.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace rt::grade {

namespace {

// A student's answer with as many tokens of their own is not the project's by chance. Stage 13's
// has 31, most of which are in a hint, and of the stages with more to write, stage 3's fewest: 49.
constexpr std::size_t fewest_own_tokens = 40;

/// The number of tokens that are in both texts, in order.
std::size_t common_tokens(const std::string& tokens, const std::string& other) {
    std::vector<std::size_t> longest(other.size() + 1);  // common subsequences, of a row's starts
    for (const char token : tokens) {
        std::size_t before = 0;
        for (std::size_t j = 0; j < other.size(); ++j) {
            const std::size_t above = longest[j + 1];
            longest[j + 1] = token == other[j] ? before + 1 : std::max(above, longest[j]);
            before = above;
        }
    }
    return longest.back();
}

/// True if the project's adds enough to the starter.
bool has_much_to_write(const std::string& projects, std::string_view starter) {
    return projects.size() - common_tokens(projects, normalized(starter)) >= fewest_own_tokens;
}

/// True if the text contains each comment of the other, which are at the ends of lines.
bool has_comments_of(std::string_view other, std::string_view text) {
    for (std::size_t at = other.find("//"); at != std::string_view::npos;
         at = other.find("//", at)) {
        const std::size_t end = std::min(other.find_first_of("\r\n", at), other.size());
        if (text.find(other.substr(at, end - at)) == std::string_view::npos) return false;
        at = end;
    }
    return true;
}

}  // namespace

int percent_of_main(std::string_view text, std::string_view projects, std::string_view starter) {
    const std::string ours = normalized(projects);
    const std::string tokens = normalized(text);
    const std::size_t longer = std::max(ours.size(), tokens.size());
    const std::size_t shorter = std::min(ours.size(), tokens.size());
    if (100 * shorter < like_main_percent * longer || !has_much_to_write(ours, starter)) return 0;
    return int(100 * common_tokens(tokens, ours) / longer);
}

bool is_copy_of_main(std::string_view text, std::string_view projects, std::string_view starter) {
    const std::string tokens = normalized(projects);
    if (normalized(text) != tokens) return false;
    return has_much_to_write(tokens, starter) || has_comments_of(projects, text);
}

}  // namespace rt::grade
