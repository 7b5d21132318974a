// `./course own --check`: the pictures of the student's own ray tracer beside the reference's.
#pragma once

#include "common/image/image.hpp"

#include <chrono>
#include <filesystem>
#include <string>

namespace rt {

/// The stage whose program draws the scenes of a check: all shapes, lights, shadows.
inline constexpr int own_check_stage = 10;

/// The student's program, build/tracer in the folder. Throws InputError if it is not there.
[[nodiscard]] std::filesystem::path own_program(const std::filesystem::path& folder);

/// The programs and the folders of a check.
struct OwnCheck {
    std::filesystem::path program;    ///< the student's
    std::filesystem::path reference;  ///< the reference program of own_check_stage
    std::filesystem::path project;    ///< with the scenes; pictures are written to its renders/
    std::chrono::seconds limit{60};   ///< of the student's program, for one scene
};

/// Runs the student's program, `tracer SCENE PICTURE`, on three scenes, compares each picture, PPM
/// or PNG, with the reference's, and prints one line for each scene: how many pixels differ, or why
/// there is no picture. Returns 0 if all pictures agree, else 1.
[[nodiscard]] int check_own(const OwnCheck& check);

// Reading of PPM files, the simplest pictures.

/// The picture of a PPM file, P6 (bytes) or P3 (decimal numbers), with 255 levels of a color.
/// Throws InputError, located at the file, if it is none, or if its size is not the expected one.
[[nodiscard]] Image read_ppm(const std::string& file, Resolution expected);

}  // namespace rt
