#include "scenes/gallery/scene_text.hpp"
#include "scenes/gallery/scenes.hpp"

#include <cmath>
#include <numbers>

namespace rt {

std::string sunflower() {
    SceneText scene;
    scene.comment(
        "Stage 3: Vogel's model of a sunflower. Each seed is a golden angle further round.");
    scene.line("R 1280 960");
    scene.element("C") << glm::dvec3(0, -3.75, 9.4) << glm::dvec3(0.012, 0.358, -1) << 41.5;
    scene.element("sky") << paint(0xffc890) << paint(0x2f5f9f);
    scene.element("sp") << glm::dvec3(0, 0.35, -3.05) << 7.6 << paint(0x3a1430)
                        << "# between the seeds";
    constexpr int seeds = 760;
    const double golden_angle = std::numbers::pi * (3 - std::sqrt(5));
    for (int i = 0; i < seeds; ++i) {
        const double share = double(i) / seeds;
        const double angle = i * golden_angle;
        const double radius = 0.135 * std::sqrt(i + 0.5);
        const double height = 1.05 * (1 - 1.6 * share * share) + 0.18 * std::cos(3.1 * radius);
        scene.element("sp") << glm::dvec3(radius * std::cos(angle), radius * std::sin(angle),
                                          height)
                            << 0.225 + 0.10 * share
                            << ramp({0xffe27a, 0xff9a3c, 0xf0503c, 0xb02a6a, 0x5a2a88, 0x28408f,
                                     0x1f7aa8, 0x54c0b0},
                                    std::sqrt(share));
    }
    return scene.text() + "\n";
}

}  // namespace rt
