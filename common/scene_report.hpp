// What a reader of scenes says: warnings once a kind, errors at once.
#pragma once

#include "common/input_error.hpp"
#include "common/scene_lexer.hpp"
#include "common/scene_reading.hpp"

#include <set>
#include <string>

namespace rt {

class SceneReport {
public:
    SceneReport(const std::string& file, const SceneReading& reading);

    [[nodiscard]] Place place(int line, int column) const { return {file_, line, column}; }

    /// Throws InputError with its place.
    [[noreturn]] void fail(int line, int column, const std::string& message) const;

    /// Warns, if nothing of this kind was warned of before.
    void warn(int line, int column, const std::string& kind, const std::string& message);

    /// What the format does not have, but a reader can live with: fails in strict reading, else
    /// warns, saying also what is done about it.
    void doubt(int line, int column, const std::string& kind, const std::string& message,
               const std::string& remedy);

    [[nodiscard]] bool strict() const { return reading_.strict; }

private:
    std::string file_;
    SceneReading reading_;
    std::set<std::string> warned_;
};

}  // namespace rt
