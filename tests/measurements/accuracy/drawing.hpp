// A scene drawn by the references, in either precision.
#pragma once

#include "common/image/image.hpp"
#include "common/render/render_settings.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace rt {

/// A picture, and the processor's time that it took once the scene was read.
struct Drawing {
    Image image;
    double seconds = 0;
};

/// Draws a scene that was read before.
using Drawer = std::function<Drawing(const RenderSettings&)>;

// drawn draws once; rendered takes the shortest time of several runs; drawer reads a scene for
// several pictures. A hierarchy is built from so many shapes of a kind on, or where it is the
// default for 0.
inline namespace f32 {
[[nodiscard]] Drawer drawer(const std::string& scene, Resolution size,
                            std::size_t hierarchy_from = 0);
[[nodiscard]] Drawing drawn(const std::string& scene, Resolution size,
                            const RenderSettings& settings, std::size_t hierarchy_from = 0);
[[nodiscard]] Drawing rendered(const std::string& scene, Resolution size,
                               const RenderSettings& settings);
}  // namespace f32
inline namespace f64 {
[[nodiscard]] Drawer drawer(const std::string& scene, Resolution size,
                            std::size_t hierarchy_from = 0);
[[nodiscard]] Drawing drawn(const std::string& scene, Resolution size,
                            const RenderSettings& settings, std::size_t hierarchy_from = 0);
[[nodiscard]] Drawing rendered(const std::string& scene, Resolution size,
                               const RenderSettings& settings);
}  // namespace f64

/// The project's scenes, by name.
[[nodiscard]] std::vector<std::filesystem::path> all_scenes();

/// These, and some that are hard to choose for: gaps, far from the origin, rare penumbrae.
[[nodiscard]] std::vector<std::filesystem::path> scenes_for_choices();

/// The difference between two pictures of one size, in levels of 255.
struct Difference {
    double error = 0;  ///< the root of its mean square over all pixels, of each the worst channel
    int most = 0;
    double other = 0;  ///< the share of the pixels that differ at all
    double seen = 0;   ///< the share that differ by more than two steps
    double edges = 0;  ///< the fraction that differs where b has an edge: a neighbor of another
                       ///< color
};

[[nodiscard]] Difference difference(const Image& a, const Image& b);

}  // namespace rt
