// The one exception of the project: bad input from outside.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>

namespace rt {

/// A location in a file that the user can open. Line and column count from 1; 0 omits them.
struct FileLocation {
    std::string file;
    int line = 0;
    int column = 0;
};

/// Bad input: a scene, a mesh, an option, a file that cannot be read or written. It is caught once,
/// in main, which prints what() and exits with status 2.
class InputError : public std::runtime_error {
public:
    /// what() is "file:line:column: error: message", one line; an empty file name omits the
    /// location.
    InputError(const FileLocation& place, const std::string& message);

    /// Returns the same error with `remark` appended in brackets.
    [[nodiscard]] InputError with(const std::string& remark) const;

private:
    explicit InputError(const std::string& text);
};

/// Receives each warning, "file:line:column: warning: …". An empty function discards them.
using Warn = std::function<void(const std::string&)>;

/// "file:line:column: " or the known part of it, with control characters replaced by "?".
[[nodiscard]] std::string to_string(const FileLocation& place);

}  // namespace rt
