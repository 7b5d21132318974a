// What a stage's program does with a scene that it has read, for those who do not care in which
// precision.
#pragma once

#include "common/options.hpp"

#include <array>
#include <atomic>
#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

namespace rt {

class Pace;

/// What a scene requires that settings can spare or spoil.
struct Demands {
    bool sized_lights = false;
    bool mirrors = false;
    double shininess = 1;                                  ///< the largest exponent of a highlight
    double extent = 0;                                     ///< as InputRounding::largest
    double feature = 0;                                    ///< as InputRounding::smallest
    double gap = std::numeric_limits<double>::infinity();  ///< as InputRounding::gap
    std::size_t most_alike = 0;      ///< shapes in the longest list that a hierarchy could replace
    std::size_t hierarchy_from = 0;  ///< what arrange takes if nobody has tried
    double unit_roundoff = 0;        ///< of the precision
};

/// A color as a picture shows it, not yet rounded: 0 to 255 each.
using Shade = std::array<double, 3>;

/// Which of the picture's pixels to draw, and how.
struct ShotSettings {
    std::size_t pixels = 0;  ///< the first of a fixed order, spread evenly over the picture
    int round = 0;           ///< each draws its own samples
    int threads = 1;
    const std::atomic<bool>* stop = nullptr;  ///< set to give up
};

struct Shot {
    std::vector<Shade> shades;
    double seconds = 0;  ///< of CPU time, for each pixel
};

class Session {
public:
    Session() = default;
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;
    virtual ~Session() = default;

    [[nodiscard]] virtual Resolution resolution() const = 0;
    [[nodiscard]] virtual Demands demands() const = 0;

    /// Builds hierarchies over the kinds of shape of which there are so many.
    virtual void arrange(std::size_t hierarchy_from) = 0;

    /// The same for any number of threads. Of no worth if it was stopped.
    [[nodiscard]] virtual Shot shot(const Look& look, const ShotSettings& settings) const = 0;

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
