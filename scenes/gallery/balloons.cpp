#include "scenes/gallery/scene_text.hpp"
#include "scenes/gallery/scenes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace rt {

namespace {

struct Balloon {
    glm::dvec3 center;
    double diameter;
};

bool are_apart(const Balloon& a, const Balloon& b) {
    const glm::dvec3 way = a.center - b.center;
    const double size = a.diameter + b.diameter;
    return std::hypot(way.x, way.y, way.z) >= 0.52 * size &&
           std::hypot(way.x, way.y) >= 0.30 * size;
}

/// Random places in an ellipse, apart from each other, and not one behind the other.
std::vector<Balloon> bunch(std::size_t count) {
    std::vector<Balloon> balloons;
    for (int i = 1; balloons.size() < count; ++i) {
        const auto random = [i](int which, double range) {
            return range * (random_of({i, which}) - 0.5);
        };
        const Balloon next{.center = {random(1, 7.6), 1.55 + random(2, 4.6), random(3, 4.5)},
                           .diameter = 1.375 + random(4, 0.45)};
        if (std::hypot((next.center.x - 0.2) / 3.7, (next.center.y - 1.55) / 2.25) > 1) continue;
        const auto is_apart = [&](const Balloon& other) { return are_apart(next, other); };
        if (std::all_of(balloons.begin(), balloons.end(), is_apart)) balloons.push_back(next);
    }
    return balloons;
}

constexpr std::array<std::uint32_t, 8> colors = {0xe23b3b, 0xf28c28, 0xf6c945, 0x4caf6d,
                                                 0x2f9fd0, 0x5a5fc0, 0xc04f9a, 0xf2f2ee};
constexpr glm::dvec3 hand(0.15, -3.6, 0.6);  ///< where all strings end

}  // namespace

std::string balloons() {
    SceneText scene;
    scene.comment("Stage 9: balloons, which throw no shadow that one would miss.");
    scene.line("R 1280 960");
    scene.element("A") << 0.30 << paint(0xe8f0ff);
    scene.element("C") << glm::dvec3(0, 0.62, 12) << glm::dvec3(0.01, 0.01, -1) << 36;
    scene.element("L") << glm::dvec3(-9, 11, 9) << 0.62 << paint(0xfff0d8) << "# the sun";
    scene.element("L") << glm::dvec3(8, -4, 6) << 0.18 << paint(0xffd0c0) << "# the ground";
    scene.element("sky") << paint(0xdff0ff) << paint(0x1f78d8);
    const std::vector<Balloon> all = bunch(23);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto [center, diameter] = all[i];
        const Light3 color = paint(colors[i % colors.size()]);
        const glm::dvec3 way = hand - center;
        const glm::dvec3 down = way / std::hypot(way.x, way.y, way.z);
        const glm::dvec3 neck = center + 0.58 * diameter * down;
        const glm::dvec3 string = hand - neck;
        scene.element("sp") << center << diameter << color << "spec:0.75 shin:90";
        scene.element("co") << neck << -down << 0.36 * diameter << 0.20 * diameter << color
                            << "spec:0.3";
        scene.element("co") << neck - 0.01 * down << down << 0.15 << 0.09 << color;
        scene.element("cy") << (hand + neck) / 2.0 << down << 0.018
                            << std::hypot(string.x, string.y, string.z) << paint(0x7a7068);
    }
    return scene.text() + "\n";
}

}  // namespace rt
