// Whole pictures for the comparison of Raysteps with its peers, POV-Ray and Tachyon.
#pragma once

#include "common/scene/scene.hpp"

#include <iosfwd>
#include <span>
#include <string>

namespace measurements {

/// The render settings of a picture, which a scene file does not contain.
struct Effort {
    int depth = 8;  ///< mirror upon mirror
    int shadow_samples = 16;
};

/// One of the pictures.
struct PeerScene {
    std::string name;  ///< of its files
    std::string what;
    rt::Resolution size{.width = 1920, .height = 1440};
    Effort effort;
    double tachyon_bar = 1;  ///< the largest accepted ratio of the time to Tachyon's
    std::string (*text)();   ///< as `.rt`, without the size
};

[[nodiscard]] std::span<const PeerScene> peer_scenes();

/// The shortest text that reads back as the same float.
[[nodiscard]] std::string f32_text(double value);

/// The scene, its meshes loaded, as a file for POV-Ray.
void write_povray(std::ostream& out, const rt::Scene& scene, const Effort& effort);

/// The same as a file for Tachyon, which has neither cones nor area lights: such a light becomes as
/// many points as there would be shadow rays. Throws InputError if there is a cone.
void write_tachyon(std::ostream& out, const rt::Scene& scene, const Effort& effort);

}  // namespace measurements
