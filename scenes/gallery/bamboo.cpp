#include "scenes/gallery/scene_text.hpp"
#include "scenes/gallery/scenes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace rt {

namespace {

struct Stalk {
    double x;
    double distance;  ///< from the eye
    double diameter;
    int number;
};

/// Far things are as pale as the mist.
Light3 in_mist(const Light3& color, double distance) {
    return mix(color, paint(0xdfe8c4), 1 - std::exp(-distance / 24));
}

bool overlap(const Stalk& a, const Stalk& b) {
    return std::abs(a.x / a.distance - b.x / b.distance) <
               0.6 * (a.diameter / a.distance + b.diameter / b.distance) &&
           std::abs(a.distance - b.distance) < 8;
}

/// Random places, which leave a glade in the middle.
std::vector<Stalk> grove(std::size_t count) {
    std::vector<Stalk> stalks;
    for (int i = 1; stalks.size() < count; ++i) {
        const auto random = [i](int which) { return random_of({i, which}); };
        const double distance = 3.2 + 42 * std::pow(random(1), 1.35);
        const Stalk next{.x = (2 * random(2) - 1) * (0.72 * distance + 0.5),
                         .distance = distance,
                         .diameter = 0.17 + 0.13 * random(3),
                         .number = i};
        if (distance < 9 && std::abs(next.x / distance - 0.06) < 0.13) continue;
        const auto overlaps = [&](const Stalk& other) { return overlap(next, other); };
        if (std::none_of(stalks.begin(), stalks.end(), overlaps)) stalks.push_back(next);
    }
    return stalks;
}

void add(SceneText& scene, const Stalk& stalk) {
    const auto random = [&](int which) { return random_of({stalk.number, which}); };
    const glm::dvec3 axis = unit({0.22 * (random(4) - 0.5), 1, 0.15 * (random(5) - 0.5)});
    const glm::dvec3 foot(stalk.x, 0, -stalk.distance);
    const Light3 color = ramp({0x1f5a2e, 0x2f7a36, 0x5a9a40, 0x86b050}, random(6));
    scene.element("cy") << foot + 4.0 * axis << axis << stalk.diameter << 70
                        << in_mist(color, stalk.distance);
    const Light3 ring = in_mist(mix(color, paint(0xe8e0b0), 0.55), stalk.distance);
    const double spacing = 0.75 + 0.5 * random(7);
    for (double y = random(8) - 0.5 * stalk.distance; y < 2.3 + 0.7 * stalk.distance; y += spacing)
        scene.element("cy") << foot + y * axis << axis << 1.14 * stalk.diameter << 0.045 << ring;
}

/// A stalk that was cut and leans on the others: its hollow end points to the eye.
void add_cut(SceneText& scene) {
    constexpr glm::dvec3 end(-0.55, 1.45, -2.7);
    const glm::dvec3 axis = unit({0.62, 0.62, -1});
    const Light3 color = paint(0x7da03e);
    scene.element("cy") << end + 2.5 * axis << axis << 0.34 << 5 << color;
    scene.element("cy") << end + 2.5 * axis << axis << 0.30 << 5 << paint(0xe0d6a4);
    for (const double along : {0.6, 1.5, 2.5, 3.6})
        scene.element("cy") << end + along * axis << axis << 0.38 << 0.06
                            << mix(color, paint(0xe8e0b0), 0.5);
}

/// A leaf: two triangles, one to each side of its middle.
void add_leaf(SceneText& scene, int number) {
    const auto random = [number](int which) { return random_of({number, which}); };
    const double distance = 3.5 + 26 * random(21);
    const glm::dvec3 stem((random(22) - 0.5) * 1.9 * distance,
                          2.3 + distance * (0.16 + 0.36 * random(23)), -distance);
    const double turn = 2 * std::numbers::pi * random(24);
    const double length = 0.45 + 0.35 * random(25);
    const glm::dvec3 along =
        unit({0.8 * std::cos(turn), -0.55 - 0.3 * random(26), 0.8 * std::sin(turn)});
    const glm::dvec3 across = unit({-along.z, 0.4 * (random(27) - 0.5), along.x});
    const Light3 color = in_mist(ramp({0x3f8a34, 0x7fb040, 0xa8c858}, random(28)), distance);
    for (const double side : {0.07, -0.07})
        scene.element("tr") << stem << stem + 0.35 * length * along + side * across
                            << stem + length * along << color;
}

}  // namespace

std::string bamboo() {
    SceneText scene;
    scene.comment("Stage 7: bamboo is a cylinder. Mist is a matter of color: far stalks are pale.");
    scene.line("R 1280 960");
    scene.element("C") << glm::dvec3(0, 2.3, 0) << glm::dvec3(0.04, 0.02, -1) << 52;
    scene.element("sky") << paint(0xc9d8a8) << paint(0xf2f6e0);
    for (const Stalk& stalk : grove(95)) add(scene, stalk);
    scene.comment("one that was cut");
    add_cut(scene);
    scene.comment("leaves");
    for (int i = 0; i < 260; ++i) add_leaf(scene, i);
    return scene.text() + "\n";
}

}  // namespace rt
