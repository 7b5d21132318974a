// One element's line, taken word by word.
#pragma once

#include "common/scene_report.hpp"

#include <array>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

namespace rt {

/// How messages speak of an element.
struct ElementForm {
    std::string_view keyword;  ///< "sp"
    std::string_view noun;     ///< "a sphere"
    std::string_view layout;   ///< "sp position diameter colour"
};

/// The fields, then the options. Whatever is not taken in the end is too much.
class ElementLine {
public:
    /// The line's first word is the keyword. The report must outlive this.
    ElementLine(Line line, const ElementForm& form, SceneReport& report);

    /// The value of the option `key:value`, if the line has it. Only after all fields.
    [[nodiscard]] std::optional<Token> option(std::string_view key);

    /// Which of the values the option has, the first if it is absent. Only after all fields.
    [[nodiscard]] int choice(std::string_view key, std::initializer_list<std::string_view> values);

    /// Whether nothing but words `key:value` follows: lenient reading then takes no field.
    [[nodiscard]] bool only_options_follow();

    /// Whether the next field is a triple; blanks around its commas are fine in lenient reading.
    [[nodiscard]] bool triple_follows() const;

    /// Where the keyword stands.
    [[nodiscard]] Place place() const;

    /// Throws InputError with the place of the keyword.
    [[noreturn]] void refuse_line(const std::string& message) const;

    /// Fails (warns, in lenient reading) if anything is left.
    void finish();

protected:
    /// "a sphere's diameter"
    [[nodiscard]] std::string what(std::string_view field) const;

    /// Throws InputError with the place and the text of a token: "message, not "text"".
    [[noreturn]] void refuse(Token token, const std::string& message) const;
    void doubt(Token token, const std::string& kind, const std::string& message,
               const std::string& remedy);
    void warn(Token token, const std::string& kind, const std::string& message);
    [[nodiscard]] bool strict() const { return report_.strict(); }

    /// The next field, of one word. Throws InputError if there is none.
    [[nodiscard]] Token take_word(std::string_view field);

    /// The parts of the next field, a triple. Throws InputError if there is none.
    [[nodiscard]] std::array<Token, 3> take_triple(std::string_view field);

    /// The parts of the option `key:x,y,z`, if the line has it. Only after all fields.
    [[nodiscard]] std::optional<std::array<Token, 3>> option_triple(std::string_view key);

    /// Whether what follows has no comma, and a word that is neither a number nor `key:value`.
    [[nodiscard]] bool words_without_triple() const;

    /// Leaves out words before a colour that cannot be one, if a triple comes later on the line.
    void skip_to_triple(std::string_view field);

    [[nodiscard]] bool at_end() const { return next_ == line_.tokens.size(); }
    [[nodiscard]] std::string missing(std::string_view field) const;
    [[nodiscard]] Token end_of_line() const;

private:
    [[nodiscard]] std::size_t words_around_commas() const;
    [[nodiscard]] std::size_t words_of_field() const;
    [[nodiscard]] Token peek_field() const;
    void refuse_blanks();
    [[nodiscard]] Token take(std::string_view field, std::size_t words);

    Line line_;
    ElementForm form_;
    SceneReport& report_;
    std::size_t next_ = 1;
};

}  // namespace rt
