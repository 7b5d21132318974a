#include "common/course/grade/results/winnowing.hpp"

#include "common/system/hash.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

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

std::size_t line_end(std::string_view source, std::size_t at) {
    while (at < source.size() && source[at] != '\n') at += source[at] == '\\' ? 2 : 1;
    return std::min(at, source.size());
}

/// Empty for keywords that change nothing.
std::string_view token(std::string_view name) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 17> words{{
        {"if", "I"},
        {"else", "E"},
        {"for", "F"},
        {"while", "W"},
        {"do", "D"},
        {"return", "R"},
        {"switch", "S"},
        {"case", "C"},
        {"break", "B"},
        {"continue", "N"},
        {"const", ""},
        {"constexpr", ""},
        {"noexcept", ""},
        {"inline", ""},
        {"static", ""},
        {"using", "U"},
        {"namespace", ""},
    }};
    if (std::isdigit(static_cast<unsigned char>(name.front())) != 0) return "0";
    for (const auto& [word, letter] : words)
        if (word == name) return letter;
    return "n";
}

std::vector<std::uint64_t> hashes(const std::string& tokens) {
    std::vector<std::uint64_t> all;
    for (std::size_t i = 0; i + passage <= tokens.size(); ++i)
        all.push_back(fnv1a(std::string_view(tokens).substr(i, passage)));
    return all;
}

std::vector<std::uint64_t> each_once(std::vector<std::uint64_t> all) {
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

}  // namespace

std::string normalized(std::string_view source) {
    std::string tokens;
    for (std::size_t at = 0; at < source.size();) {
        const char each = source[at];
        if (source.substr(at).starts_with("//") || each == '#') {
            at = line_end(source, at);
        } else if (source.substr(at).starts_with("/*")) {
            at = after(source, "*/", at + 2);
        } else if (source.substr(at).starts_with("::")) {
            if (tokens.ends_with('n')) tokens.pop_back();
            at += 2;
        } else if (each == '"' || each == '\'') {
            tokens += 't';
            at = end_of_text(source, at);
        } else if (is_of_name(each)) {
            const std::size_t end = end_of_name(source, at);
            tokens += token(source.substr(at, end - at));
            at = end;
        } else {
            if (std::isgraph(static_cast<unsigned char>(each)) != 0 && each != '{' && each != '}')
                tokens += each;
            ++at;
        }
    }
    return tokens;
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

}  // namespace rt::grade
