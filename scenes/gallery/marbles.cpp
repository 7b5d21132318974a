#include "scenes/gallery/scene_text.hpp"
#include "scenes/gallery/scenes.hpp"

#include <glm/vec2.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace rt {

namespace {

constexpr double ground = 1000;  ///< the radius of the ground, which is a sphere too
constexpr std::array<glm::dvec2, 3> large = {{{-3.6, 0}, {0, 0}, {3.6, 0.2}}};
constexpr std::array<std::uint32_t, 10> colors = {0xe4572e, 0xf2a541, 0xf3d250, 0x76b041, 0x2e9e8f,
                                                  0x3d7fc4, 0x5b4b9a, 0xc44a86, 0xf4efe6, 0x2b2f3a};

/// Whether a sphere of radius 1 leaves room for one of this radius.
bool has_room(double x, double z, double radius) {
    return std::none_of(large.begin(), large.end(), [=](glm::dvec2 center) {
        return std::hypot(x - center.x, z - center.y) < 1.05 + 0.9 * radius;
    });
}

void add_small(SceneText& scene, int column, int row, int number) {
    const auto random = [number](int which) { return random_of({number, which}); };
    const double radius = 0.17 + 0.09 * random(4);
    const double x = 0.9 * column + 0.62 * random(1);
    const double z = 0.9 * row + 0.62 * random(2);
    if (!has_room(x, z, radius)) return;
    const double y = std::sqrt(std::pow(ground + radius, 2) - x * x - z * z) - ground;
    const double kind = random(3);
    const Light3 color = paint(colors[std::size_t(random(5) * colors.size())]);
    scene.element("sp") << glm::dvec3(x, y, z) << 2 * radius
                        << (kind > 0.9 ? paint(0xf2f4f8) : color);
    if (kind > 0.78)
        scene.option("mirror:", 0.55 + 0.4 * random(6)) << "spec:0.8 shin:200";
    else if (kind > 0.35)
        scene << "spec:0.45 shin:50";
}

}  // namespace

std::string marbles() {
    SceneText scene;
    scene.comment(
        "Stage 12: after the cover of Ray Tracing in One Weekend, with mirrors for its glass.");
    scene.line("R 1280 960");
    scene.element("A") << 0.22 << paint(0xdfe8ff);
    scene.element("C") << glm::dvec3(11.5, 2.5, 4.6) << glm::dvec3(-0.918, -0.134, -0.372) << 24;
    scene.element("L") << glm::dvec3(9, 14, 10) << 0.80 << paint(0xfff2dc) << "radius:1.6";
    scene.element("sky") << paint(0xe4f0fa) << paint(0x2a7ad8);
    scene.element("sp") << glm::dvec3(0, -ground, 0) << 2 * ground << paint(0x5f6a60);
    scene.element("sp") << glm::dvec3(-3.6, 1, 0) << 2 << paint(0xc8463a) << "spec:0.4 shin:40";
    scene.element("sp") << glm::dvec3(0, 1, 0) << 2 << paint(0xeef2f6)
                        << "mirror:0.92 spec:0.9 shin:400";
    scene.element("sp") << glm::dvec3(3.6, 1, 0.2) << 2 << paint(0xd8a840)
                        << "mirror:0.75 spec:0.9 shin:400";
    int number = 0;
    for (int column = -11; column < 12; ++column)
        for (int row = -11; row < 9; ++row) add_small(scene, column, row, ++number);
    return scene.text() + "\n";
}

}  // namespace rt
