// What choosing settings needs of a scene: what it requires, and trials of a few of its pixels.
#pragma once

#include "common/look.hpp"
#include "common/pixel.hpp"

#include <array>
#include <atomic>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace rt {

/// What a scene requires that settings can spare or spoil.
struct Demands {
    bool sized_lights = false;
    double shininess = 1;                                  ///< the largest exponent of a highlight
    double extent = 0;                                     ///< as InputRounding::largest
    double feature = 0;                                    ///< as InputRounding::smallest
    double gap = std::numeric_limits<double>::infinity();  ///< as InputRounding::gap
    double strongest_mirror = 0;     ///< the largest share of what a shape faces that it shows
    std::size_t shapes = 0;          ///< triangles of meshes too
    std::size_t most_alike = 0;      ///< shapes in the longest list that a hierarchy could replace
    std::size_t hierarchy_from = 0;  ///< what arrange takes if nobody has tried
    double unit_roundoff = 0;        ///< of the precision
};

/// A color as a picture shows it, not yet rounded: 0 to 255 each.
using Shade = std::array<double, 3>;

/// Which of the picture's pixels to draw, and how.
struct ShotSettings {
    std::span<const Pixel> pixels;
    int round = 0;  ///< each draws its own samples
    int threads = 1;
    const std::atomic<bool>* stop = nullptr;  ///< set to give up
};

/// What was drawn, and what it took: the rays are the same in every run, the seconds are not.
struct Shot {
    std::vector<Shade> shades;    ///< in the order of the pixels
    std::vector<int> light_rays;  ///< of each pixel, to lights with a size
    double rays = 0;              ///< of all kinds, for each pixel in the mean
    double seconds = 0;           ///< of CPU time, for each pixel
};

class Trials {
public:
    Trials() = default;
    Trials(const Trials&) = delete;
    Trials& operator=(const Trials&) = delete;
    virtual ~Trials() = default;

    [[nodiscard]] virtual Resolution resolution() const = 0;
    [[nodiscard]] virtual Demands demands() const = 0;

    /// Builds hierarchies over the kinds of shape of which there are so many.
    virtual void arrange(std::size_t hierarchy_from) = 0;

    /// The same for any number of threads. Of no worth if it was stopped.
    [[nodiscard]] virtual Shot shot(const Look& look, const ShotSettings& settings) const = 0;
};

}  // namespace rt
