// The text of a mesh file, split into lines and words for the checks before OpenMesh reads it.
#pragma once

#include "common/system/input_error.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace rt {

/// Replaces a byte order mark, which some editors write at the start of a text, with blanks.
void blank_byte_order_mark(std::string& content);

/// Replaces a byte order mark with blanks, and CR with LF if no line ends in LF. Adds the end of
/// the last line if it is missing, because OpenMesh's streams must not reach the end of the file
/// inside a number. Replaces vertical tab and form feed with blanks, because OpenMesh's readers
/// treat them differently.
void plain_text(std::string& content);

/// The lines of a text, in order. The text may be modified between calls.
class MeshLines {
public:
    MeshLines(const std::string& text, std::string file) : text_(text), file_(std::move(file)) {}

    /// Returns the next line that contains a word, without its end; nothing after the last.
    [[nodiscard]] std::optional<std::string_view> next();
    /// The offset in the text of the following line.
    [[nodiscard]] std::size_t position() const { return position_; }
    /// The number of bytes from there to the end of the text.
    [[nodiscard]] std::size_t left() const { return text_.size() - position_; }
    /// The number of the last returned line, from 1.
    [[nodiscard]] int number() const { return number_; }
    /// Throws InputError at the last line.
    [[noreturn]] void refuse(const std::string& message) const;

private:
    const std::string& text_;
    std::string file_;
    std::size_t position_ = 0;
    int number_ = 0;
};

/// Removes the next word from the line and returns it; empty if there is none.
[[nodiscard]] std::string_view take_word(std::string_view& line);

/// The number of words in the line.
[[nodiscard]] std::size_t count_words(std::string_view line);

/// Parses the whole word as an integer; nothing if it is not one of 64 bits.
[[nodiscard]] std::optional<std::int64_t> whole_number(std::string_view word);

/// Removes the next word from the line and returns it as an integer, which may begin with '+';
/// nothing, and the line still has the word, if it is not one of 64 bits.
[[nodiscard]] std::optional<std::int64_t> take_whole_number(std::string_view& line);

/// Parses the whole word as a float; nothing if it is not one, or out of range.
[[nodiscard]] std::optional<float> float_number(std::string_view word);

/// Removes the next word from the line and returns it as a float; nothing, and the line still has
/// the word, if float_number returns nothing.
[[nodiscard]] std::optional<float> take_float(std::string_view& line);

/// Removes three words from the line. Throws InputError unless each is a number that a float can
/// represent; `what` names their owner in the message.
void require_three_numbers(std::string_view& line, const char* what, const MeshLines& lines);

/// Throws InputError if the rest of a line begins with a word that is not a number, as in a file
/// whose line ends are lost. More numbers are skipped: a color, for example.
void require_no_word(std::string_view rest, const char* what, const MeshLines& lines);

}  // namespace rt
