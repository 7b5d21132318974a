#include "common/course/grade/results/winnowing.hpp"

#include "common/system/hash.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace rt::grade {

namespace {

constexpr std::size_t passage = 16;
constexpr std::size_t window = 8;

bool is_of_name(char each) {
    const auto byte = static_cast<unsigned char>(each);
    return std::isalnum(byte) != 0 || each == '_' || byte >= 0x80;
}

/// The first place from `from` on that is not part of a name or number: "g_1", "1'000.5".
std::size_t end_of_name(std::string_view source, std::size_t from) {
    const bool number = std::isdigit(static_cast<unsigned char>(source[from])) != 0;
    const auto goes_on = [number](char each) {
        return is_of_name(each) || (number && (each == '.' || each == '\''));
    };
    while (from < source.size() && goes_on(source[from])) ++from;
    return from;
}

/// The position just after the closing text, or the end.
std::size_t after(std::string_view source, std::string_view closing, std::size_t from) {
    const std::size_t at = source.find(closing, from);
    return at == std::string_view::npos ? source.size() : at + closing.size();
}

std::size_t end_of_text(std::string_view source, std::size_t at) {
    const char quote = source[at];
    for (++at; at < source.size() && source[at] != quote && source[at] != '\n'; ++at)
        if (source[at] == '\\') ++at;
    return std::min(at + 1, source.size());
}

/// Without the ends of lines after a backslash, which continue on the next one, and without a byte
/// order mark. All other ends of lines are "\n", old Macs' too.
std::string spliced(std::string_view source) {
    constexpr std::string_view mark = "\xef\xbb\xbf";
    if (source.starts_with(mark)) source.remove_prefix(mark.size());
    std::string text;
    for (std::size_t at = 0; at < source.size(); ++at) {
        const bool is_two = source.substr(at).starts_with("\r\n");
        if (is_two) ++at;
        const char each = source[at] == '\r' ? '\n' : source[at];
        if (each == '\n' && text.ends_with('\\'))
            text.pop_back();
        else
            text += each;
    }
    return text;
}

/// The first place of a preprocessor line that counts: the text of a #define, or else the line's
/// end.
std::size_t after_directive(std::string_view source, std::size_t at) {
    const std::size_t word = source.find_first_not_of("#%: \t", at);
    if (word != std::string_view::npos && source.substr(word).starts_with("define"))
        return word + std::string_view("define").size();
    return std::min(source.find('\n', at), source.size());
}

/// The place after the captures of a lambda that begin here; here, if these brackets are an index.
std::size_t after_captures(std::string_view source, std::size_t at, std::string_view tokens) {
    const bool is_index =
        !tokens.empty() && std::string_view("n)]t").find(tokens.back()) != std::string_view::npos;
    return is_index ? at : after(source, "]", at);
}

/// Empty for keywords that change nothing, or may be left out.
std::string_view token(std::string_view name) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 20> words{{
        {"if", "I"},    {"else", "E"},     {"for", "F"},     {"while", "W"}, {"do", "D"},
        {"return", ""}, {"switch", "S"},   {"case", "C"},    {"break", "B"}, {"continue", "N"},
        {"const", ""},  {"constexpr", ""}, {"noexcept", ""}, {"inline", ""}, {"static", ""},
        {"using", "U"}, {"namespace", ""}, {"and", "&&"},    {"or", "||"},   {"not", "!"},
    }};
    if (std::isdigit(static_cast<unsigned char>(name.front())) != 0) return "0";
    for (const auto& [word, letter] : words)
        if (word == name) return letter;
    return "n";
}

void append_sign(char each, std::string& tokens) {
    if (std::isgraph(static_cast<unsigned char>(each)) == 0 || each == '{' || each == '}') return;
    if (each == ')' && tokens.ends_with('('))
        tokens.pop_back();
    else if (each != ';' || !tokens.ends_with(';'))
        tokens += each;
}

std::vector<std::uint64_t> hashes(const std::string& tokens) {
    std::vector<std::uint64_t> all;
    for (std::size_t i = 0; i + passage <= tokens.size(); ++i)
        all.push_back(fnv1a(std::string_view(tokens).substr(i, passage)));
    return all;
}

std::vector<std::uint64_t> each_once(std::vector<std::uint64_t> all) {
    std::ranges::sort(all);
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

}  // namespace

std::string normalized(std::string_view unspliced) {
    const std::string spliced_source = spliced(unspliced);
    const std::string_view source = spliced_source;
    std::string tokens;
    bool starts_line = true;
    for (std::size_t at = 0; at < source.size();) {
        const char each = source[at];
        const std::string_view rest = source.substr(at);
        const bool may_be_directive = std::exchange(
            starts_line, each == '\n' || (starts_line && (each == ' ' || each == '\t')));
        if (rest.starts_with("//")) {
            at = std::min(source.find('\n', at), source.size());
        } else if (may_be_directive && (each == '#' || rest.starts_with("%:"))) {
            at = after_directive(source, at);
        } else if (rest.starts_with("/*")) {
            at = after(source, "*/", at + 2);
            starts_line = may_be_directive;
        } else if (rest.starts_with("::")) {
            if (tokens.ends_with('n')) tokens.pop_back();
            at += 2;
        } else if (rest.starts_with("<%") || rest.starts_with("%>")) {
            at += 2;  // braces
        } else if (each == '[' && after_captures(source, at, tokens) != at) {
            at = after_captures(source, at, tokens);
        } else if (each == '"' || each == '\'') {
            tokens += 't';
            at = end_of_text(source, at);
        } else if (is_of_name(each)) {
            const std::size_t end = end_of_name(source, at);
            tokens += token(source.substr(at, end - at));
            at = end;
        } else {
            append_sign(each, tokens);
            ++at;
        }
    }
    return tokens;
}

std::string without_fillers(const std::string& tokens) {
    constexpr std::size_t fewest = 6;
    std::map<std::string_view, std::size_t> counts;
    const auto each_statement = [&tokens](auto work) {
        for (std::size_t at = 0; at < tokens.size();) {
            const std::size_t end = after(tokens, ";", at);
            work(std::string_view(tokens).substr(at, end - at));
            at = end;
        }
    };
    std::size_t all = 0;
    each_statement([&](std::string_view statement) { ++counts[statement], ++all; });
    std::string kept;
    each_statement([&](std::string_view statement) {
        const std::size_t count = counts[statement];
        if (count < fewest || 3 * count < all) kept += statement;
    });
    return kept;
}

std::vector<std::uint64_t> passages(const std::string& tokens) {
    return each_once(hashes(tokens));
}

std::vector<std::uint64_t> fingerprints(const std::string& tokens) {
    const std::vector<std::uint64_t> all = hashes(tokens);
    std::vector<std::uint64_t> least;
    for (auto first = all.begin(); first != all.end(); ++first) {
        const auto last = first + std::min<std::ptrdiff_t>(window, all.end() - first);
        least.push_back(*std::min_element(first, last));
        if (last == all.end()) break;
    }
    return each_once(std::move(least));
}

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
