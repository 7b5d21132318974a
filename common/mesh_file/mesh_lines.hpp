// The text of a mesh file, split into lines and words.
#pragma once

#include "common/system/input_error.hpp"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace rt {

/// Replaces a byte order mark, which some editors write at the start of a text, with blanks.
void blank_byte_order_mark(std::string& content);

/// Replaces a byte order mark, vertical tab and form feed with blanks, and CR with LF if no line
/// ends in LF.
void plain_text(std::string& content);

/// Replaces comments with blanks, from that byte on: from '#' to the end of the line.
void blank_comments(std::string& content, std::size_t from = 0);

/// The lines of a text, in order. A copy goes on from the same line.
class MeshLines {
public:
    MeshLines(std::string_view text, std::string file) : text_(text), file_(std::move(file)) {}

    /// Returns the next line that contains a word, without its end; nothing after the last.
    [[nodiscard]] std::optional<std::string_view> next();
    /// Returns the next line, which may be empty, without its end; nothing after the last.
    [[nodiscard]] std::optional<std::string_view> next_of_any_kind();
    /// The offset in the text of the following line.
    [[nodiscard]] std::size_t position() const { return position_; }
    /// The number of bytes from there to the end of the text.
    [[nodiscard]] std::size_t left() const { return text_.size() - position_; }
    /// The number of the last returned line, from 1.
    [[nodiscard]] int number() const { return number_; }
    /// Throws InputError at the last line.
    [[noreturn]] void refuse(const std::string& message) const;
    /// Throws InputError for a list, of `count` vertices for example, that ends after so many.
    [[noreturn]] void refuse_end(std::uint64_t read, std::uint64_t count,
                                 const std::string& items) const;

private:
    std::string_view text_;
    std::string file_;
    std::size_t position_ = 0;
    int number_ = 0;
};

/// Removes the next word from the line and returns it; empty if there is none.
[[nodiscard]] std::string_view take_word(std::string_view& line);

[[nodiscard]] std::size_t count_words(std::string_view line);

/// Parses the whole word as an integer, which may begin with '+'; nothing if it is not one of 64
/// bits.
[[nodiscard]] std::optional<std::int64_t> whole_number(std::string_view word);

/// Removes the next word from the line and returns it as an integer, which may begin with '+';
/// nothing, and the line still has the word, if it is not one of 64 bits.
[[nodiscard]] std::optional<std::int64_t> take_whole_number(std::string_view& line);

/// Removes the next word from the line and returns it as a number; nothing, and the line still has
/// the word, if it is not one, or float cannot represent it.
[[nodiscard]] std::optional<double> take_number(std::string_view& line);

/// As take_number; NaN for a word that programs write for NaN and infinity, as nan, -inf, 1.#IND.
[[nodiscard]] std::optional<double> take_number_or_nan(std::string_view& line);

/// Removes three words from the line. Throws InputError unless each is a number that a float can
/// represent; `what` names their owner in the message.
[[nodiscard]] glm::dvec3 take_point(std::string_view& line, const char* what,
                                    const MeshLines& lines);

/// As take_point, for a vector of which take_number_or_nan accepts each number, or the line ends
/// before it: NaN.
[[nodiscard]] glm::dvec3 take_normal(std::string_view& line, const char* what,
                                     const MeshLines& lines);

/// Throws InputError if the rest of a line begins with a word that is not a number, as in a file
/// whose line ends are lost. More numbers are skipped: a color, for example.
void require_no_word(std::string_view rest, const char* what, const MeshLines& lines);

}  // namespace rt
