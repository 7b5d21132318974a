#include "common/scene_file/diagnostics.hpp"

namespace rt {

namespace {

/// A limit on the number of warnings, so that a file that is not a scene does not fill the
/// terminal.
constexpr std::size_t most_warnings = 20;

}  // namespace

SceneReport::SceneReport(const std::string& file, const SceneReading& reading)
    : file_(file), reading_(reading) {}

void SceneReport::fail(int line, int column, const std::string& message) const {
    throw InputError({file_, line, column}, message);
}

void SceneReport::warn(int line, int column, const std::string& kind, const std::string& message) {
    if (!reading_.warn || warned_.size() > most_warnings) return;
    if (!warned_.insert(kind).second) return;
    const bool last = warned_.size() > most_warnings;
    reading_.warn(to_string(FileLocation{file_, line, column}) +
                  "warning: " + (last ? "further warnings are omitted" : message));
}

void SceneReport::doubt(int line, int column, const std::string& kind, const std::string& message,
                        const std::string& remedy) {
    if (reading_.strict) fail(line, column, message);
    warn(line, column, kind, message + "; " + remedy);
}

}  // namespace rt
