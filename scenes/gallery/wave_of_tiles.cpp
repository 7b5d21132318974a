#include "scenes/gallery/scene_text.hpp"
#include "scenes/gallery/scenes.hpp"

#include <cmath>

namespace rt {

namespace {

double height(double x, double z) {
    const double from_center = std::hypot(x - 1.1, z + 2.2);
    return 0.80 * std::cos(1.9 * from_center) * std::exp(-0.19 * from_center) +
           0.16 * std::sin(0.8 * x - 0.6 * z);
}

glm::dvec3 upward(double x, double z) {
    constexpr double step = 1e-4;
    return {(height(x - step, z) - height(x + step, z)) / (2 * step), 1,
            (height(x, z - step) - height(x, z + step)) / (2 * step)};
}

}  // namespace

std::string wave_of_tiles() {
    SceneText scene;
    scene.comment(
        "Stage 6: tiles on a wave. Each square's normal is that of the wave at its center.");
    scene.line("R 1280 960");
    scene.element("C") << glm::dvec3(-0.4, 2.9, 6.4) << glm::dvec3(0.09, -0.345, -1) << 42;
    scene.element("sky") << paint(0xffc48a) << paint(0x5aa8dc);
    scene.element("sq") << glm::dvec3(0, -1.3, -7) << glm::dvec3(0, 1, 0) << 22 << paint(0x10304a);
    constexpr int rows = 76;
    constexpr double spacing = 0.26;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < rows; ++column) {
            const double x = (column - 0.5 * (rows - 1)) * spacing;
            const double z = 4.6 - row * spacing;
            if (std::abs(x) > 0.62 * (7.6 - z) + 0.5) continue;  // beside the picture
            const double y = height(x, z);
            const double share = (y + 0.45) / 0.95 + 0.10 * (random_of({column, row}) - 0.5);
            scene.element("sq") << glm::dvec3(x, y, z) << unit(upward(x, z)) << 0.93 * spacing
                                << ramp({0x12355b, 0x1b6d8c, 0x2aa198, 0x8cc98f, 0xf4d58d, 0xf2a65a,
                                         0xe2604a},
                                        share);
        }
    return scene.text() + "\n";
}

}  // namespace rt
