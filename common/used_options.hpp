// The options that make a picture what it is, as they are given on a command line.
#pragma once

#include "common/options.hpp"

#include <string>

namespace rt {

/// All but the precision, and none that changes nothing: of the output, or the threads.
[[nodiscard]] std::string used_options(const Program& program, const Options& options);

/// "--precision double --shade phong --shadow-samples 16 --depth 8": with the scene and its size
/// they make the same file again, byte for byte.
[[nodiscard]] std::string equivalent_options(const Program& program, const Options& options);

/// "double".
[[nodiscard]] const char* name(Precision precision);

}  // namespace rt
