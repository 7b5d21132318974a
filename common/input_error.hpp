// The one exception of the project: something that came from outside is wrong.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>

namespace rt {

/// A place in a file that somebody can open. Line and column count from 1; 0 leaves them out.
struct Place {
    std::string file;
    int line = 0;
    int column = 0;
};

/// Bad input: a scene, a mesh, an option, a file that cannot be read or written. Caught once, in
/// main, which prints what() and ends with status 2.
class InputError : public std::runtime_error {
public:
    /// what() is "file:line:column: error: message", one line; an empty file leaves the place out.
    InputError(const Place& place, const std::string& message);

    /// The same error with "remark" in brackets at its end.
    [[nodiscard]] InputError with(const std::string& remark) const;

private:
    explicit InputError(const std::string& text);
};

/// Takes each warning, "file:line:column: warning: …". May be empty: then nobody does.
using Warn = std::function<void(const std::string&)>;

/// "file:line:column: ", or as much of it as is known, with "?" for control characters.
[[nodiscard]] std::string to_string(const Place& place);

}  // namespace rt
