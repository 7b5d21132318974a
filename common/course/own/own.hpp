// `./course own`: a ray tracer outside the project, begun with the student's stages.
#pragma once

#include "common/image/image.hpp"
#include "common/system/files.hpp"

#include <chrono>
#include <string>

namespace rt {

/// Writes a new folder with the student's files of all started stages of the project, except their
/// main.cpp, the headers that these files include, an almost empty main.cpp, a CMakeLists.txt and a
/// README.md. Prints which stages are left out, and warns of includes that the contracts of the
/// stages do not lead to. The folder appears complete or not at all. Throws InputError if it exists
/// and is not empty, or if no stage is started. Returns 0.
int lay_out_own(const fs::path& project, const fs::path& destination);

/// The shell command that builds the program in the folder. With Ninja, since `./course` installs
/// it and not make, CMake's default.
[[nodiscard]] std::string own_build_command(const fs::path& folder);

// `./course own --check`: its pictures beside the reference's.

/// The stage whose program draws the scenes of a check: all shapes, lights, shadows.
inline constexpr int own_check_stage = 10;

/// The student's program, build/tracer in the folder. Throws InputError if it is not there.
[[nodiscard]] fs::path own_program(const fs::path& folder);

struct OwnCheck {
    fs::path program;                ///< the student's
    fs::path reference;              ///< the reference program of own_check_stage
    fs::path project;                ///< with the scenes; pictures are written to its renders/
    std::chrono::seconds limit{60};  ///< of the student's program, for one scene
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
