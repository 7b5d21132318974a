// Diagnostics of the scene reader: the first warning of each kind, and errors.
#pragma once

#include "common/scene_file/lexer.hpp"
#include "common/scene_file/reader.hpp"
#include "common/system/input_error.hpp"

#include <set>
#include <string>

namespace rt {

/// Reports errors and warnings with their location in one scene file.
class SceneReport {
public:
    SceneReport(const std::string& file, const SceneReading& reading);

    [[nodiscard]] FileLocation place(int line, int column) const { return {file_, line, column}; }

    /// Throws InputError with this location.
    [[noreturn]] void fail(int line, int column, const std::string& message) const;

    /// Reports a warning, unless one of the same kind was reported before.
    void warn(int line, int column, const std::string& kind, const std::string& message);

    /// Handles content outside the format that can be ignored: throws InputError in strict reading,
    /// otherwise warns and appends the remedy.
    void doubt(int line, int column, const std::string& kind, const std::string& message,
               const std::string& remedy);

    [[nodiscard]] bool strict() const { return reading_.strict; }

private:
    std::string file_;
    SceneReading reading_;
    std::set<std::string> warned_;
};

}  // namespace rt
