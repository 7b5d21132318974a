// Command line options of a stage's program.
#pragma once

#include "common/image/pixel.hpp"
#include "common/scene_file/reader.hpp"
#include "common/tuning/auto_settings.hpp"

#include <array>
#include <optional>
#include <string>

namespace rt {

/// The number of the stage whose program this is (stage_number.cpp).
extern const int stage_number;

/// The stage's program that is running.
struct Program {
    int stage = 1;
    std::string root;    ///< folder of the project, which contains its scenes and pictures
    bool exact = false;  ///< built from certified kernels
};

/// The values of `--precision`.
enum class Precision { f32, f64, exact };

/// The parsed options, with their defaults.
struct Options : Aim {
    std::optional<std::size_t>
        hierarchy_from;  ///< smallest number of shapes of a kind for a hierarchy, if given
    std::string scene;   ///< path of the scene file
    std::string output;  ///< path of the picture
    SceneReading reading;
    std::optional<Resolution> size;  ///< overrides the scene's resolution
    int camera = 1;                  ///< number of the scene's camera, from 1
    std::optional<int> turn;         ///< frames of an animation in which the camera goes around
    std::optional<Pixel> pixel;      ///< print the log of this pixel, and make no picture
    std::optional<Pixel> rays;       ///< print the drawing of its rays, and make no picture
    std::optional<std::array<double, 2>> shade_range;  ///< ends of the scale of colors of --shade
    Precision precision = Precision::f64;
    bool precision_given = false;
    bool requirements = false;  ///< print the scene's requirements, and make no picture
    bool preview = false;
    bool quiet = false;

    [[nodiscard]] bool makes_picture() const { return !requirements && !pixel && !rays; }
};

/// Parses the command line. Returns nothing if it only requested help, which has then been printed.
/// Throws InputError for an unknown option or an invalid value.
[[nodiscard]] std::optional<Options> parse_options(const Program& program, int argc,
                                                   const char* const* argv);

}  // namespace rt
