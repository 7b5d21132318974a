// The options --shade and --shade-range of a stage's program.
#pragma once

#include "common/program/options.hpp"

#include <functional>
#include <string>

namespace CLI {
class App;
}

namespace rt {

/// The word of `--shade` for a shading in a stage's program.
[[nodiscard]] std::string shade_word(int stage, Shading shading);

/// Adds the options of what a pixel shows.
void add_shade_options(CLI::App& app, int stage, Options& options);

/// Returns true if the command line contains the option of this name, such as "--depth".
using IsGiven = std::function<bool(const std::string& option)>;

/// Throws InputError for options that have no meaning together with a picture of numbers.
void check_shade_options(int stage, const Options& options, const IsGiven& is_given);

}  // namespace rt
