// Shortcuts for reading a scene in a test.
#pragma once

#include "common/scene_file/reader.hpp"

#include "steps/step02_camera_basis/camera_basis.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace rt {
inline namespace RT_PRECISION {

inline const std::string camera = "C 0,0,0 0,0,-1 60\n";

struct Lenient {
    Scene scene;
    std::vector<std::string> warnings;
};

/// The result of lenient reading of the text, called scene.rt.
inline Lenient lenient(std::string_view text, SceneReading reading = {}) {
    Lenient result;
    reading.warn = [&result](const std::string& warning) { result.warnings.push_back(warning); };
    result.scene = parse_scene(text, "scene.rt", orthonormal_basis, reading);
    return result;
}

/// The result of strict reading.
inline Scene strict(std::string_view text) {
    return parse_scene(text, "scene.rt", orthonormal_basis, {.strict = true});
}

/// The error message; "accepted" if there is none.
inline std::string refusal(std::string_view text, bool strict) {
    try {
        static_cast<void>(parse_scene(text, "scene.rt", orthonormal_basis, {.strict = strict}));
        return "accepted";
    } catch (const InputError& error) {
        return error.what();
    }
}

inline std::string lenient_refusal(std::string_view text) {
    return refusal(text, false);
}

inline std::string strict_refusal(std::string_view text) {
    return refusal(text, true);
}

/// A scene whose third line is the tested one.
inline std::string with_camera(const std::string& line) {
    return "R 640 480\nC 0,0,0 0,0,-1 60\n" + line + "\n";
}

}  // namespace RT_PRECISION
}  // namespace rt
