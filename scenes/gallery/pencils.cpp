#include "scenes/gallery/scene_text.hpp"
#include "scenes/gallery/scenes.hpp"

#include <cmath>
#include <numbers>

namespace rt {

std::string pencils() {
    SceneText scene;
    scene.comment(
        "Stage 8: pencils. Two cones have one axis: the wood, and the lead around its tip.");
    scene.line("R 1280 960");
    scene.element("C") << glm::dvec3(0.3, 7.2, 4.9) << glm::dvec3(-0.01, -1, -0.66) << 30;
    scene.element("sky") << paint(0xc0b8a8) << paint(0xdfe6ea);
    scene.element("pl") << glm::dvec3(0) << glm::dvec3(0, 1, 0) << paint(0xe9e2d4);
    constexpr int count = 36;
    constexpr double radius = 0.16;
    constexpr double body = 4.2;
    constexpr double wood = 0.70;
    constexpr double lead = 0.26;
    for (int i = 0; i < count; ++i) {
        const double turn = double(i) / count;
        const double angle = 2 * std::numbers::pi * turn;
        const glm::dvec3 outward(std::cos(angle), 0, std::sin(angle));
        const auto at = [&](double distance) {
            return distance * outward + glm::dvec3(0, radius, 0);
        };
        // Green looks brighter than other hues, and blue darker.
        const double green = std::exp(-std::pow((turn - 0.36) / 0.13, 2));
        const double blue = std::exp(-std::pow((turn - 0.68) / 0.09, 2));
        const Light3 color = hue(turn, 0.80 - 0.12 * blue, 0.90 - 0.16 * green);
        const double tip = i % 2 == 0 ? 1.05 : 1.31;
        scene.element("cy") << at(tip + wood + body / 2) << outward << 2 * radius << body << color;
        scene.element("co") << at(tip) << outward << 2 * radius << wood << paint(0xe8bd86);
        scene.element("co") << at(tip - 0.01) << outward << 2 * radius * (lead + 0.012) / wood
                            << lead << color;
    }
    return scene.text() + "\n";
}

}  // namespace rt
