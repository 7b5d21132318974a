// One element's line of a scene file, consumed word by word.
#pragma once

#include "common/scene_file/diagnostics.hpp"

#include <array>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace rt {

/// The words for an element in messages.
struct ElementForm {
    std::string_view keyword;  ///< "sp"
    std::string_view noun;     ///< "a sphere"
    std::string_view layout;   ///< "sp position diameter color"
};

/// A line consists of fields, then options. Words left over at the end are an error.
class ElementLine {
public:
    /// The first word of `line` is the keyword. The report must outlive this object.
    ElementLine(Line line, const ElementForm& form, SceneReport& report);

    /// The value of the option `key:value`; nothing if the line does not have it. Call it only
    /// after all fields.
    [[nodiscard]] std::optional<Token> option(std::string_view key);

    /// The index of the option's value in `values`; 0 if the option is absent. Throws InputError
    /// for any other value. Call it only after all fields.
    [[nodiscard]] int choice(std::string_view key, std::initializer_list<std::string_view> values);

    /// Returns whether words follow, and none of them starts with a digit, a sign or a point, so
    /// that lenient reading does not consume a field.
    [[nodiscard]] bool no_number_follows() const;

    /// Returns whether the next field is a triple or a color `#rrggbb`. Lenient reading accepts
    /// blanks around the commas of a triple.
    [[nodiscard]] bool color_follows();

    /// The location of the keyword.
    [[nodiscard]] FileLocation place() const;

    /// Throws InputError at the location of the keyword.
    [[noreturn]] void refuse_line(const std::string& message) const;

    /// Throws InputError if words are left over; lenient reading warns instead.
    void finish();

protected:
    /// The name of the field in messages: "a sphere's diameter".
    [[nodiscard]] std::string what(std::string_view field) const;

    /// Throws InputError at the location of a token, with its text: "message, not "text"".
    [[noreturn]] void refuse(Token token, const std::string& message) const;
    void doubt(Token token, const std::string& kind, const std::string& message,
               const std::string& remedy);
    void warn(Token token, const std::string& kind, const std::string& message);
    [[nodiscard]] bool strict() const { return report_.strict(); }

    /// Consumes the next field, a single word. Throws InputError if there is none.
    [[nodiscard]] Token take_word(std::string_view field);

    /// Consumes the next field, a triple, and returns its three parts. Throws InputError if there
    /// is none.
    [[nodiscard]] std::array<Token, 3> take_triple(std::string_view field);

    /// The three parts of the option `key:x,y,z`; nothing if the line does not have it. Call it
    /// only after all fields.
    [[nodiscard]] std::optional<std::array<Token, 3>> option_triple(std::string_view key);

    /// The number of words that follow with two commas, options left out.
    [[nodiscard]] std::ptrdiff_t triples_follow() const;

    /// The last word with a letter, other than a number, before the next word with a comma.
    [[nodiscard]] std::optional<Token> last_word_before_triple() const;

    void skip_rest() { next_ = line_.tokens.size(); }

    /// Returns whether the rest of the line has no comma of a triple, and has a word that is
    /// neither a number nor an option of this format.
    [[nodiscard]] bool words_without_triple() const;

    /// Returns whether the next word is `#rrggbb` or `#rgb`. It is not a comment if a color would
    /// be missing without it: call this only where a color is the next field.
    [[nodiscard]] bool hexadecimal_follows();

    /// Skips words before a color that cannot be part of one, if a triple follows later on the
    /// line, or `#rrggbb` after its other words.
    void skip_to_color(std::string_view field);

    [[nodiscard]] bool at_end() const { return next_ == line_.tokens.size(); }

    /// The message that the field is missing. If a comment is where a color should be, `#red` say,
    /// the message explains that.
    [[nodiscard]] std::string missing(std::string_view field) const;
    [[nodiscard]] Token end_of_line() const;

private:
    [[nodiscard]] std::span<const Token> rest() const {
        return std::span(line_.tokens).subspan(next_);
    }
    [[nodiscard]] std::size_t words_around_commas() const;
    [[nodiscard]] Token peek_field() const;
    void take_color_from_comment();
    [[nodiscard]] Token take(std::string_view field, std::size_t words);

    Line line_;
    ElementForm form_;
    SceneReport& report_;
    std::size_t next_ = 1;
    std::vector<std::string> taken_;  ///< the options that were read
};

}  // namespace rt
