// The interface between the automatic request and a scene: the traits of the scene, and samples of
// its pixels.
#pragma once

#include "common/image/pixel.hpp"
#include "common/render/render_settings.hpp"

#include <array>
#include <atomic>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace rt {

/// The traits of a scene that affect the choice of request.
struct SceneTraits {
    bool sized_lights = false;
    double shininess = 1;                                  ///< largest exponent of a highlight
    double extent = 0;                                     ///< as InputRounding::largest
    double feature = 0;                                    ///< as InputRounding::smallest
    double gap = std::numeric_limits<double>::infinity();  ///< as InputRounding::gap
    double strongest_mirror = 0;                           ///< largest mirror strength of a shape
    std::size_t shapes = 0;          ///< number of shapes, with the triangles of meshes
    std::size_t most_alike = 0;      ///< length of the longest list that a hierarchy could replace
    std::size_t hierarchy_from = 0;  ///< default threshold of arrange for a hierarchy
    double unit_roundoff = 0;        ///< unit roundoff of the precision
};

/// A color as displayed but not rounded: 0 to 255 for each component.
using DisplayColor = std::array<double, 3>;

/// The pixels of a sample, and the way to render them.
struct SampleRequest {
    std::span<const Pixel> pixels;
    int round = 0;     ///< each round uses its own random samples
    int at_least = 0;  ///< with a pixel_error: at least so many rays through every pixel; 0 for one
                       ///< ray, and more where rays through the centers around it find an edge
    int threads = 1;
    const std::atomic<bool>* stop =
        nullptr;  ///< rendering stops when this becomes true; may be null
};

/// The colors and the cost of sample pixels. The rays are the same in every run, the seconds are
/// not.
struct PixelSample {
    std::vector<DisplayColor> shades;  ///< in the order of the pixels
    std::vector<int> light_rays;       ///< for each pixel: rays to area lights
    double rays = 0;                   ///< mean number of rays of all kinds for each pixel
    double seconds = 0;                ///< mean CPU seconds for each pixel
};

/// A scene on which request can be measured.
class Trials {
public:
    Trials() = default;
    Trials(const Trials&) = delete;
    Trials& operator=(const Trials&) = delete;
    virtual ~Trials() = default;

    [[nodiscard]] virtual Resolution resolution() const = 0;
    [[nodiscard]] virtual SceneTraits traits() const = 0;

    /// Builds a hierarchy for each kind of shape with at least this many shapes.
    virtual void build_acceleration(std::size_t hierarchy_from) = 0;

    /// Renders the pixels. The result does not depend on the number of threads. If stopped early,
    /// it is meaningless.
    [[nodiscard]] virtual PixelSample shot(const RenderSettings& settings,
                                           const SampleRequest& request) const = 0;
};

}  // namespace rt
