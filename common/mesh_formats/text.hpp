// A mesh file's text, word by word: what is checked before OpenMesh reads it.
#pragma once

#include "common/input_error.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace rt {

/// Some editors begin a text with one.
void blank_byte_order_mark(std::string& content);

/// Blanks a byte order mark. Makes the last line end, since OpenMesh's streams must not meet the
/// end of the file in a number, and vertical tab and form feed blanks, since its readers disagree
/// on them.
void plain_text(std::string& content);

/// The lines of a text, one after the other. The text may be written to between them.
class MeshLines {
public:
    MeshLines(const std::string& text, std::string file) : text_(text), file_(std::move(file)) {}

    /// The next line that has a word, without its end; nothing after the last.
    [[nodiscard]] std::optional<std::string_view> next();
    /// Where the line after that begins in the text.
    [[nodiscard]] std::size_t position() const { return position_; }
    /// How much of the text is left from there.
    [[nodiscard]] std::size_t left() const { return text_.size() - position_; }
    /// Of the line that was last, from 1.
    [[nodiscard]] int number() const { return number_; }
    [[noreturn]] void refuse(const std::string& message) const;

private:
    const std::string& text_;
    std::string file_;
    std::size_t position_ = 0;
    int number_ = 0;
};

/// Takes the next word off the line; an empty one if there is none.
[[nodiscard]] std::string_view take_word(std::string_view& line);

[[nodiscard]] std::size_t count_words(std::string_view line);

/// The whole number that all of the word spells, if 64 bits hold it.
[[nodiscard]] std::optional<std::int64_t> whole_number(std::string_view word);

/// The float that all of the word spells; nothing if a float does not hold it.
[[nodiscard]] std::optional<float> float_number(std::string_view word);

/// Takes three words off the line. Refuses it unless each is a number that a float can hold: `what`
/// says of what.
void require_three_numbers(std::string_view& line, const char* what, const MeshLines& lines);

/// The word in quotes, cut if it is long, with '?' for what is not printable.
[[nodiscard]] std::string quoted_word(std::string_view word);

}  // namespace rt
