// A scene's text cut into lines and words, each with its place.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rt {

/// Characters without a blank among them. The column, in bytes, counts from 1.
struct Token {
    std::string_view text;
    int column = 0;
};

/// One line without its comment.
struct Line {
    int number = 0;  ///< from 1
    std::vector<Token> tokens;
    /// The words of a comment "# rt: word word …", which says how the file is meant.
    std::vector<Token> directives;
};

/// The lines of a text, one after the other. The text must outlive what comes from it.
class Lines {
public:
    explicit Lines(std::string_view text);

    /// The next line; nothing after the last. A comment begins at any '#' and at a word that begins
    /// with "//". CR, tab, vertical tab and form feed are blanks, and a byte order mark is skipped.
    [[nodiscard]] std::optional<Line> next();

private:
    std::string_view rest_;
    int number_ = 0;
    int skipped_ = 0;  ///< bytes of the first line before rest_: a byte order mark
};

/// From the beginning of the first to the end of the second token of the same line.
[[nodiscard]] Token joined(Token first, Token last);

/// The text in double quotes for a message: cut when it is long, and what is not printable ASCII
/// written as \xNN, so that no file can play with somebody's terminal.
[[nodiscard]] std::string quoted(std::string_view text);

}  // namespace rt
