// The command line of a stage's program.
#pragma once

#include "common/look.hpp"
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

constexpr int most_shadow_samples = 1 << 20;

/// Which settings are not to be chosen, because the command line says them.
struct Given {
    bool precision = false;
    bool shadow_samples = false;  ///< or when to stop sampling
    bool depth = false;
};

struct Options {
    std::string scene;   ///< a file
    std::string output;  ///< a file
    SceneReading reading;
    std::optional<Resolution> size;  ///< instead of the scene's
    std::optional<Pixel> pixel;      ///< tell its story, and make no picture
    Precision precision = Precision::f64;
    Look look;
    std::optional<double> tolerance;  ///< choose for this error of a pixel, in 8-bit steps
    std::optional<double> time;       ///< choose for this many seconds
    Given given;
    bool explain = false;  ///< say what the scene requires, and make no picture
    int threads = 1;
    bool preview = false;
    bool quiet = false;
};

/// What the command line asks for; nothing if all it asked for, help, has been printed. Throws
/// InputError for an option that is unknown, or a value that is none.
[[nodiscard]] std::optional<Options> parse_options(const Program& program, int argc,
                                                   const char* const* argv);

}  // namespace rt
