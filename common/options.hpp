// The command line of a stage's program.
#pragma once

#include "common/choice.hpp"
#include "common/pixel.hpp"
#include "common/scene_reader.hpp"

#include <optional>
#include <string>

namespace rt {

/// The program that somebody runs.
struct Program {
    int stage = 1;
    std::string root;    ///< the folder of the project: own scenes and pictures are in there
    bool exact = false;  ///< of certified kernels
};

enum class Precision { f32, f64, exact };

struct Options : Aim {
    std::string scene;   ///< a file
    std::string output;  ///< a file
    SceneReading reading;
    std::optional<Resolution> size;  ///< instead of the scene's
    int camera = 1;                  ///< which of the scene's
    std::optional<Pixel> pixel;      ///< tell its story, and make no picture
    Precision precision = Precision::f64;
    bool precision_given = false;
    bool explain = false;  ///< say what the scene requires, and make no picture
    bool preview = false;
    bool quiet = false;

    [[nodiscard]] bool makes_picture() const { return !explain && !pixel; }
};

/// What the command line asks for; nothing if all it asked for, help, has been printed. Throws
/// InputError for an option that is unknown, or a value that is none.
[[nodiscard]] std::optional<Options> parse_options(const Program& program, int argc,
                                                   const char* const* argv);

}  // namespace rt
