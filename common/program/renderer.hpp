// The renderer of a loaded scene, independent of precision.
#pragma once

#include "common/program/options.hpp"
#include "common/tuning/trial.hpp"

#include <atomic>
#include <memory>
#include <string>
#include <vector>

namespace rt {

class TimeBudget;

/// A loaded scene. The automatic settings are measured on it.
class Renderer : public Trials {
public:
    /// Renders the picture, or prints the log of one pixel, and reports the result. A time budget
    /// `pace`, if not null, changes the settings from row to row. Returns false, and leaves no
    /// file, if it was stopped.
    [[nodiscard]] virtual bool run(const Options& options, TimeBudget* pace,
                                   const std::atomic<bool>& stop) = 0;
};

// Each function reads the scene in its precision. Throws InputError if the scene is wrong. A
// program of certified kernels has only the second one.
inline namespace f32 {
[[nodiscard]] std::unique_ptr<Renderer> make_renderer(const Program& program,
                                                      const Options& options);
}
inline namespace f64 {
[[nodiscard]] std::unique_ptr<Renderer> make_renderer(const Program& program,
                                                      const Options& options);

/// Returns one sentence for each loss of accuracy with `--precision float` (input_rounding.hpp).
/// Reads the scene file again, without its meshes; returns nothing for a pipe, which cannot be read
/// twice.
[[nodiscard]] std::vector<std::string> risks_in_float(const Options& options);
}  // namespace f64

}  // namespace rt
