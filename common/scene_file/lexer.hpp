// Lexer of scene files: lines and words with their locations.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace rt {

/// The characters that separate words, CR, vertical tab and form feed among them.
inline constexpr std::string_view blanks = " \t\r\v\f";

/// A word without blanks. The column, in bytes, counts from 1.
struct Token {
    std::string_view text;
    int column = 0;
};

/// One line: the words before its comment, and the comment.
struct Line {
    int number = 0;  ///< from 1
    std::vector<Token> tokens;
    Token comment;  ///< from its "#" or "//" to the end of the line; empty if there is none
    /// The words of a comment "# rt: word word …", which sets how the file is read.
    std::vector<Token> directives;
};

/// The byte that ends the text's lines: LF, or CR in a text without LF.
[[nodiscard]] char line_end(std::string_view text);

/// The lines of a text, in order. The text must outlive this object and its tokens.
class Lines {
public:
    explicit Lines(std::string_view text);

    /// Returns the next line; nothing after the last. A comment starts at any '#', and at a word
    /// that starts with "//". CR, tab, vertical tab and form feed are blanks; a byte order mark is
    /// skipped.
    [[nodiscard]] std::optional<Line> next();

private:
    std::string_view rest_;
    char end_;
    int number_ = 0;
    int skipped_ = 0;  ///< length in bytes of a byte order mark before rest_, in the first line
};

/// Appends the first word of the line's comment to its tokens, with all words up to another
/// comment, which becomes the line's.
void take_from_comment(Line& line);

/// One token from the start of `first` to the end of `last`, in the same line.
[[nodiscard]] Token joined(Token first, Token last);

}  // namespace rt
