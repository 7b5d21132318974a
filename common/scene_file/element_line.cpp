#include "common/scene_file/element_line.hpp"

#include "common/system/escaping.hpp"
#include "common/system/text.hpp"

#include <algorithm>
#include <utility>

namespace rt {

namespace {

std::ptrdiff_t commas(std::string_view text) {
    return std::ranges::count(text, ',');
}

bool is_letter(char c) {
    return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z');
}

Token trimmed(Token token) {
    const std::size_t begin = std::min(token.text.find_first_not_of(blanks), token.text.size());
    token.text.remove_prefix(begin);
    token.column += static_cast<int>(begin);
    token.text = token.text.substr(0, token.text.find_last_not_of(blanks) + 1);
    return token;
}

/// Returns whether the text has the form `key:value`, with a key that starts with a letter.
bool is_option(std::string_view text) {
    return is_letter(text.front()) && text.find(':') != std::string_view::npos;
}

/// Returns whether the text is an option of another program, or a function, such as
/// `cb:0,255,0:0,0,255` or `checker(0,0,0;1,1,1)`: commas in it are no triple's.
bool is_foreign_option(std::string_view text) {
    constexpr auto known = std::to_array<std::string_view>(
        {"spec", "shin", "mirror", "sides", "radius", "dir", "normals"});
    const std::size_t end = text.find_first_of(":(");
    return is_letter(text.front()) && end < text.find(',') &&
           (text[end] == '(' || std::ranges::find(known, text.substr(0, end)) == known.end());
}

/// Returns whether the text may be a triple, or a part of one.
bool has_commas(std::string_view text) {
    return commas(text) > 0 && !is_foreign_option(text);
}

/// Returns whether the text has a character that no number has.
bool is_word(std::string_view text) {
    return text.find_first_not_of("+-.0123456789eE") != std::string_view::npos;
}

/// Returns whether the text has the form `#rrggbb` or `#rgb`.
bool is_hexadecimal(std::string_view text) {
    return (text.size() == 7 || text.size() == 4) && text.front() == '#' &&
           text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string_view::npos;
}

/// The three parts around two commas; nothing if there are not exactly two commas, or if a part is
/// empty.
std::optional<std::array<Token, 3>> three_parts(Token token) {
    if (commas(token.text) != 2) return std::nullopt;
    std::array<Token, 3> parts;
    for (Token& part : parts) {
        const std::size_t comma = std::min(token.text.find(','), token.text.size());
        part = trimmed({token.text.substr(0, comma), token.column});
        if (part.text.empty()) return std::nullopt;
        token.text.remove_prefix(std::min(comma + 1, token.text.size()));
        token.column += static_cast<int>(comma) + 1;
    }
    return parts;
}

}  // namespace

ElementLine::ElementLine(Line line, const ElementForm& form, SceneReport& report)
    : line_(std::move(line)), form_(form), report_(report) {}

std::optional<Token> ElementLine::option(std::string_view key) {
    for (auto token = line_.tokens.begin() + static_cast<std::ptrdiff_t>(next_);
         token != line_.tokens.end(); ++token) {
        if (!token->text.starts_with(key) || !token->text.substr(key.size()).starts_with(':'))
            continue;
        const std::size_t start = key.size() + 1;
        const Token value{token->text.substr(start), token->column + static_cast<int>(start)};
        line_.tokens.erase(token);
        taken_.emplace_back(key);
        return value;
    }
    return std::nullopt;
}

std::optional<std::array<Token, 3>> ElementLine::option_triple(std::string_view key) {
    const auto value = option(key);
    if (!value) return std::nullopt;
    if (const auto parts = three_parts(*value)) return parts;
    refuse(*value, what(key) + " must be three numbers as in 1,2,3");
}

int ElementLine::choice(std::string_view key, std::initializer_list<std::string_view> values) {
    const auto value = option(key);
    if (!value) return 0;
    const auto* const found = std::ranges::find(values, value->text);
    if (found != values.end()) return static_cast<int>(found - values.begin());
    refuse(*value, what(key) + " must be " + joined(values, {}, " or "));
}

bool ElementLine::no_number_follows() const {
    const auto is_like_number = [](Token token) {
        return std::string_view("+-.0123456789").find(token.text.front()) != std::string_view::npos;
    };
    return !strict() && !at_end() && std::ranges::none_of(rest(), is_like_number);
}

std::ptrdiff_t ElementLine::triples_follow() const {
    return std::ranges::count_if(
        rest(), [](Token token) { return commas(token.text) == 2 && !is_option(token.text); });
}

std::optional<Token> ElementLine::last_word_before_triple() const {
    std::optional<Token> last;
    for (const Token token : rest()) {
        if (commas(token.text) > 0 || is_option(token.text)) break;
        if (is_word(token.text) && std::ranges::any_of(token.text, is_letter)) last = token;
    }
    return last;
}

bool ElementLine::words_without_triple() const {
    const auto is_name = [](std::string_view text) {
        return is_word(text) && (!is_option(text) || is_foreign_option(text));
    };
    return std::ranges::none_of(rest(), has_commas, &Token::text) &&
           std::ranges::any_of(rest(), is_name, &Token::text);
}

bool ElementLine::color_follows() {
    return hexadecimal_follows() || (!at_end() && three_parts(peek_field()).has_value());
}

bool ElementLine::hexadecimal_follows() {
    if (at_end()) take_color_from_comment();
    return !at_end() && is_hexadecimal(line_.tokens[next_].text);
}

/// Appends the words of the comment to the line if the first of them is `#rrggbb` or `#rgb`.
void ElementLine::take_color_from_comment() {
    if (line_.comment.column == end_of_line().column) return;  // in the middle of a word
    Line longer = line_;
    take_from_comment(longer);
    const std::size_t words = line_.tokens.size();
    if (longer.tokens.size() > words && is_hexadecimal(longer.tokens[words].text))
        line_ = std::move(longer);
}

FileLocation ElementLine::place() const {
    return report_.place(line_.number, line_.tokens.front().column);
}

void ElementLine::refuse_line(const std::string& message) const {
    report_.fail(line_.number, line_.tokens.front().column, message);
}

void ElementLine::finish() {
    for (; !at_end(); ++next_) {
        const Token token = line_.tokens[next_];
        const bool option = is_option(token.text);
        const auto key = option ? token.text.substr(0, token.text.find(':')) : "";
        const std::size_t left = line_.tokens.size() - next_;
        const std::string of =
            std::string(form_.noun) + ": expected \"" + std::string(form_.layout) + "\"";
        doubt(token, "too much " + std::string(form_.keyword) + " " + std::string(key),
              quoted(token.text) +
                  (std::ranges::find(taken_, key) != taken_.end() ? " repeats an option of "
                   : option                                       ? " is not an option of "
                   : left == 1
                       ? " is one word too many for "
                       : " is the first of " + std::to_string(left) + " words too many for ") +
                  of,
              "it is ignored");
    }
}

std::string ElementLine::what(std::string_view field) const {
    return std::string(form_.noun) + "'s " + std::string(field);
}

void ElementLine::refuse(Token token, const std::string& message) const {
    report_.fail(line_.number, token.column, message + ", not " + quoted(token.text));
}

void ElementLine::doubt(Token token, const std::string& kind, const std::string& message,
                        const std::string& remedy) {
    report_.doubt(line_.number, token.column, kind, message, remedy);
}

void ElementLine::warn(Token token, const std::string& kind, const std::string& message) {
    report_.warn(line_.number, token.column, kind, message);
}

Token ElementLine::take_word(std::string_view field) {
    return take(field, 1);
}

std::array<Token, 3> ElementLine::take_triple(std::string_view field) {
    const Token token = take(field, at_end() ? 1 : words_around_commas());
    const auto parts = three_parts(token);
    if (!parts) refuse(token, what(field) + " must be three numbers as in 1,2,3");
    if (token.text.find_first_of(blanks) == std::string_view::npos) return *parts;
    const std::string message = "blanks around the commas of " + quoted(token.text);
    if (strict())
        report_.fail(line_.number, token.column, message + ": expected three numbers as in 1,2,3");
    warn(token, "blank in triple", message);
    return *parts;
}

void ElementLine::skip_to_color(std::string_view field) {
    const auto may_be_color = [](Token token) {
        return has_commas(token.text) || is_hexadecimal(token.text);
    };
    const auto color_is_left = [&] { return std::ranges::any_of(rest(), may_be_color); };
    if (!at_end() && !color_is_left()) take_color_from_comment();
    if (!color_is_left()) return;
    for (; !may_be_color(peek_field()); ++next_) {
        const Token token = line_.tokens[next_];
        doubt(token, "before color " + std::string(form_.keyword),
              quoted(token.text) + " is in place of " + what(field), "it is skipped");
    }
}

std::string ElementLine::missing(std::string_view field) const {
    std::string text = what(field) + " is missing: expected \"" + std::string(form_.layout) + "\"";
    const std::string_view word =
        line_.comment.text.substr(0, line_.comment.text.find_first_of(blanks));
    if (field.ends_with("color") && word.starts_with('#') && word.size() > 1)
        text += "; " + quoted(word) + " starts a comment, and a color is r,g,b as in 255,0,0";
    return text;
}

Token ElementLine::end_of_line() const {
    const Token last = line_.tokens.back();
    return {{}, last.column + static_cast<int>(last.text.size())};
}

/// The number of words in the next field: more than one if a triple has blanks around its commas. A
/// word that would add a third comma is a separate field.
std::size_t ElementLine::words_around_commas() const {
    std::size_t end = next_ + 1;
    auto count = commas(line_.tokens[next_].text);
    while (end < line_.tokens.size()) {
        const std::string_view word = line_.tokens[end].text;
        const bool touches = line_.tokens[end - 1].text.ends_with(',') || word.starts_with(',');
        if (!touches || count + commas(word) > 2) break;
        count += commas(word);
        ++end;
    }
    return end - next_;
}

Token ElementLine::peek_field() const {
    return joined(line_.tokens[next_], line_.tokens[next_ + words_around_commas() - 1]);
}

Token ElementLine::take(std::string_view field, std::size_t words) {
    if (at_end()) report_.fail(line_.number, end_of_line().column, missing(field));
    Token token = joined(line_.tokens[next_], line_.tokens[next_ + words - 1]);
    next_ += words;
    if (strict() || token.text.size() < 2 || !token.text.ends_with(',')) return token;
    doubt(token, "comma", quoted(token.text) + " ends with a comma", "the comma is ignored");
    token.text.remove_suffix(1);
    return token;
}

}  // namespace rt
