// The command line options that reproduce a picture.
#pragma once

#include "common/program/options.hpp"

#include <string>

namespace rt {

/// All options that affect the picture, except the precision; output file and threads do not affect
/// it.
[[nodiscard]] std::string used_options(const Program& program, const Options& options);

/// For example "--precision double --shade phong --shadow-samples 16 --depth 8": together with the
/// scene and its size they reproduce the file, byte for byte.
[[nodiscard]] std::string equivalent_options(const Program& program, const Options& options);

/// The option's value for a precision: "double".
[[nodiscard]] const char* name(Precision precision);

}  // namespace rt
