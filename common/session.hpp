// What a stage's program does with a scene that it has read, for those who do not care in which
// precision.
#pragma once

#include "common/options.hpp"
#include "common/trials.hpp"

#include <atomic>
#include <memory>
#include <string>
#include <vector>

namespace rt {

class Pace;

/// A scene that has been read. Tuning tries settings on it.
class Session : public Trials {
public:
    /// Makes the picture, or tells one pixel's story, and says what came of it. A pace, if there is
    /// one, changes the look from row to row. Returns false, and leaves no file, if it was stopped.
    [[nodiscard]] virtual bool run(const Options& options, Pace* pace,
                                   const std::atomic<bool>& stop) const = 0;
};

// Each reads the scene in its precision. Throws InputError for what is wrong with it. A program of
// certified kernels has the second alone.
inline namespace f32 {
[[nodiscard]] std::unique_ptr<Session> open_session(const Program& program, const Options& options);
}
inline namespace f64 {
[[nodiscard]] std::unique_ptr<Session> open_session(const Program& program, const Options& options);

/// What `--precision float` would lose of the scene, a sentence each (input_rounding.hpp). The file
/// is read for it, its meshes are not; a pipe, which cannot be read twice, is left alone.
[[nodiscard]] std::vector<std::string> risks_in_float(const Options& options);
}  // namespace f64

}  // namespace rt
