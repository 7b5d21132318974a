#include "scenes/gallery/scene_text.hpp"
#include "scenes/gallery/scenes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace rt {

namespace {

constexpr int columns = 40;
constexpr int rows = 36;

double smooth(double x) {
    return x * x * (3 - 2 * x);
}

/// Value noise: random at whole numbers, and smooth between them.
double noise(double x, double z) {
    const int i = int(std::floor(x));
    const int j = int(std::floor(z));
    const double right = smooth(x - i);
    const double far = smooth(z - j);
    const auto random = [&](int di, int dj) { return random_of({i + di + 1000, j + dj + 2000}); };
    return std::lerp(std::lerp(random(0, 0), random(1, 0), right),
                     std::lerp(random(0, 1), random(1, 1), right), far);
}

/// The height of the ground. A valley with a lake is in the middle, and the mountains rise to both
/// sides and behind it.
double height(double x, double z) {
    const double hills = 1.9 * noise(0.42 * x + 7.3, 0.42 * z + 3.1) +
                         0.8 * noise(0.95 * x, 0.95 * z + 9) + 0.28 * noise(2.1 * x + 40, 2.1 * z);
    const double back = std::clamp((3.2 - z) / 7, 0.0, 1.0);
    const double side = std::min(1.0, std::abs(x - 0.4) / 3.6);
    const double far = std::clamp((-5.5 - z) / 3, 0.0, 1.0);
    const double edge = 0.16 * std::max(0.0, std::abs(x) - 5.2);
    const double slope =
        0.30 * back + (0.80 * back + 0.25) * side * side + 0.55 * far * (1 - 0.7 * side) - edge;
    const double lake = 0.55 * (1 - back) * (1 - 0.7 * side) + 0.15;
    return 1.45 * (hills - 0.55) * std::max(0.1, slope) - lake;
}

glm::dvec3 vertex(int i, int j) {
    const double x =
        0.5 * (i + 0.5 * (j % 2)) - 0.25 * columns + 0.22 * (random_of({i, j, 1}) - 0.5);
    const double z = 4.6 - 0.46 * j + 0.2 * (random_of({i, j, 2}) - 0.5);
    return {x, height(x, z), z};
}

using Corners = std::array<glm::dvec3, 3>;

/// The share of the normal that points up or down, 0 to 1.
double levelness(const Corners& corners) {
    const glm::dvec3 a = corners[1] - corners[0];
    const glm::dvec3 b = corners[2] - corners[0];
    const glm::dvec3 normal(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
    return std::abs(normal.y) / std::hypot(normal.x, normal.y, normal.z);
}

/// Sand, grass, rock and snow by height; steep ground is rock.
Light3 ground(const Corners& corners, int number) {
    const double middle = (corners[0].y + corners[1].y + corners[2].y) / 3;
    const double share = middle / 2.3 + 0.16 * (random_of({number, 77}) - 0.5);
    if (levelness(corners) < 0.62 && share < 0.72)
        return ramp({0x7c6a5c, 0x8a7a74}, random_of({number, 5}));
    return ramp({0xc9b37a, 0x6f9a4a, 0x4f7f45, 0x6a6a58, 0x8a7a72, 0xa08c88, 0xf4f2f0, 0xffffff},
                share + 0.06);
}

void add(SceneText& scene, const Corners& corners, const Light3& color) {
    scene.element("tr") << corners[0] << corners[1] << corners[2] << color;
}

void add_ground(SceneText& scene) {
    int number = 0;
    const auto add_if_dry = [&](const Corners& corners) {
        ++number;
        if (std::max({corners[0].y, corners[1].y, corners[2].y}) >= 0)
            add(scene, corners, ground(corners, number));
    };
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            const glm::dvec3 a = vertex(i, j);
            const glm::dvec3 b = vertex(i + 1, j);
            const glm::dvec3 c = vertex(i, j + 1);
            const glm::dvec3 d = vertex(i + 1, j + 1);
            add_if_dry(j % 2 == 1 ? Corners{a, b, d} : Corners{a, b, c});
            add_if_dry(j % 2 == 1 ? Corners{a, d, c} : Corners{b, d, c});
        }
}

/// A boat folded from paper: two sides of three triangles, and its middle, in red.
void add_boat(SceneText& scene) {
    scene.comment("the paper boat");
    constexpr double size = 1.5;
    constexpr double turn = 0.5;
    const auto at = [](double along, double up, double across) {
        return glm::dvec3(0.75, 0.02, 2.6) +
               size * glm::dvec3(along * std::cos(turn) + across * std::sin(turn), up,
                                 across * std::cos(turn) - along * std::sin(turn));
    };
    const glm::dvec3 bow = at(-0.62, 0.30, 0);
    const glm::dvec3 stern = at(0.62, 0.30, 0);
    const glm::dvec3 first = at(-0.30, -0.03, 0);
    const glm::dvec3 last = at(0.30, -0.03, 0);
    for (const double across : {0.20, -0.20}) {
        const glm::dvec3 side = at(0, 0.17, across);
        add(scene, {bow, first, side}, paint(0xf6f2e8));
        add(scene, {first, last, side}, paint(0xefe9dc));
        add(scene, {last, stern, side}, paint(0xf6f2e8));
    }
    add(scene, {at(-0.24, 0.12, 0), at(0.24, 0.12, 0), at(0, 0.72, 0)}, paint(0xe2483a));
}

}  // namespace

std::string mountains() {
    SceneText scene;
    scene.comment("Stage 5: mountains of triangles, in the low sun.");
    scene.line("R 1280 960");
    scene.element("C") << glm::dvec3(0, 2.3, 11) << glm::dvec3(0.01, -0.075, -1) << 33;
    scene.element("sky") << paint(0xffb070) << paint(0x4a5fa8);
    scene.element("sp") << glm::dvec3(1.9, 2.1, -20) << 4.4 << paint(0xffe9b0) << "# the sun";
    scene.comment("the lake, and the ground around it");
    const std::array<glm::dvec3, 4> lake = {
        {{-9, 0.02, 8}, {9, 0.02, 8}, {9, 0.02, -8}, {-9, 0.02, -8}}};
    add(scene, {lake[0], lake[1], lake[2]}, paint(0x3f7f92));
    add(scene, {lake[0], lake[2], lake[3]}, paint(0x3f7f92));
    add_ground(scene);
    add_boat(scene);
    return scene.text() + "\n";
}

}  // namespace rt
