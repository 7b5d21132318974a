// The command line options that reproduce a picture.
#pragma once

#include "common/image/png.hpp"
#include "common/program/options.hpp"

#include <string>
#include <vector>

namespace rt {

/// All options that affect the picture, except the precision; output file and threads do not affect
/// it.
[[nodiscard]] std::string used_options(const Program& program, const Options& options);

/// For example "--precision double --shade phong --shadow-samples 16 --depth 8": together with the
/// scene and its size they reproduce the file, byte for byte.
[[nodiscard]] std::string equivalent_options(const Program& program, const Options& options);

/// The option's value for a precision: "double".
[[nodiscard]] const char* name(Precision precision);

// The texts that a picture's file contains beside the pixels.

/// "640 x 480"
[[nodiscard]] std::string size_text(Resolution size);

/// Returns everything that determined the picture. The number of threads does not affect it.
[[nodiscard]] std::vector<PngText> picture_texts(const Program& program, const Options& options,
                                                 Resolution size);

}  // namespace rt
