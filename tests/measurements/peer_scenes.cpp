// The eight pictures.
#include "tests/measurements/peer_scenes.hpp"

#include <glm/geometric.hpp>

#include <array>
#include <charconv>
#include <random>

namespace measurements {

namespace {

using rt::Vec3;

/// Random numbers that are the same everywhere: library distributions differ.
class Draw {
public:
    explicit Draw(unsigned seed) : engine_(seed) {}

    double between(double low, double high) {
        return low + (high - low) * (double(engine_()) * 0x1p-32);
    }

    Vec3 within(double size) {
        const double x = between(-size, size);
        const double y = between(-size, size);
        return {x, y, between(-size, size)};
    }

    /// A color that is neither dark nor white.
    std::string color() {
        const auto part = [this] { return std::to_string(int(between(50, 230))); };
        const std::string red = part();
        const std::string green = part();
        return red + "," + green + "," + part();
    }

private:
    std::mt19937 engine_;
};

/// Without an exponent, which `.rt` does not support.
std::string number(double value) {
    std::array<char, 32> text{};
    const auto fixed = std::chars_format::fixed;
    char* const end = std::to_chars(text.begin(), text.end(), value, fixed, 4).ptr;
    return {text.begin(), end};
}

std::string triple(Vec3 v) {
    return number(v.x) + "," + number(v.y) + "," + number(v.z);
}

/// The words with blanks between them, as a line.
template <class... Words>
std::string line(const Words&... words) {
    std::string text;
    ((text += (text.empty() ? "" : " ") + std::string(words)), ...);
    return text + "\n";
}

/// The picture is as high at distance 1 as it is far away.
std::string seen(Vec3 from, Vec3 to) {
    return line("C", triple(from), triple(glm::normalize(to - from)), "53.1301");
}

const std::string ambient = line("A", "0.1", "255,255,255");
const std::string sun = line("L", "-5,8,-6", "0.8", "255,255,255");
const std::string shiny = " spec:0.5 shin:40";
const std::string gray = "180,180,180";

std::string three_spheres() {
    return ambient + sun + seen({0, 1.2, -4}, {0, 0.6, 0}) +
           line("sp", "-1.2,0.5,0", "1", "230,50,50" + shiny) +
           line("sp", "0,0.75,0.5", "1.5", "50,200,75" + shiny) +
           line("sp", "1.3,0.5,-0.2", "1", "50,75,230" + shiny) +
           line("pl", "0,0,0", "0,1,0", gray);
}

std::string cornell() {
    const std::string white = "190,190,190";
    return ambient + line("L", "0,0.8,0", "0.9", "255,255,255", "radius:0.15") +
           seen({0, 0, -3.2}, {0, 0, 0}) + line("sq", "0,-1,0", "0,1,0", "2", white) +
           line("sq", "0,1,0", "0,-1,0", "2", white) + line("sq", "0,0,1", "0,0,-1", "2", white) +
           line("sq", "-1,0,0", "1,0,0", "2", "190,50,50") +
           line("sq", "1,0,0", "-1,0,0", "2", "50,190,50") +
           line("sp", "-0.4,-0.6,0.3", "0.8", "200,180,75" + shiny) +
           line("sp", "0.45,-0.65,-0.3", "0.7", "200,180,75" + shiny);
}

std::string mirror_spheres() {
    std::string text = ambient + sun + seen({0, 3.5, -6.5}, {0, 0, -0.5}) +
                       line("pl", "0,-0.45,0", "0,1,0", gray, "mirror:0.2");
    Draw draw(3);
    for (int x = 0; x < 10; ++x)
        for (int z = 0; z < 10; ++z)
            text += line("sp", triple({x - 4.5, 0, z - 4.5}), "0.9",
                         draw.color() + shiny + " mirror:0.6");
    return text;
}

std::string cloud(int count, double smallest, double largest) {
    std::string text =
        ambient + line("L", "-20,30,-25", "0.8", "255,255,255") + seen({0, 0, -12}, {0, 0, 0});
    Draw draw{unsigned(count)};
    std::vector<std::string> colors(16);
    for (std::string& color : colors) color = draw.color() + shiny;
    for (int i = 0; i < count; ++i) {
        const std::string center = triple(draw.within(5));
        text += line("sp", center, number(draw.between(smallest, largest)),
                     colors[std::size_t(i) % colors.size()]);
    }
    return text;
}

std::string mesh(const std::string& name) {
    return ambient + sun + seen({0, 0.3, -2.6}, {0, 0, 0}) +
           line("mesh", name + ".off", "0,0,0", "1", "200,150,100" + shiny, "normals:flat");
}

std::string cylinders_and_cones() {
    std::string text =
        ambient + sun + seen({0, 4, -9}, {0, 0.4, 0}) + line("pl", "0,0,0", "0,1,0", gray);
    Draw draw(6);
    for (int x = -3; x <= 3; ++x)
        for (int z = -3; z <= 3; ++z) {
            const Vec3 foot(1.4 * x, 0, 1.4 * z);
            Vec3 top = foot + draw.within(0.3);
            top.y = draw.between(0.6, 1.4);
            const std::string height = number(glm::distance(foot, top));
            const std::string up = triple(glm::normalize(top - foot));
            const std::string down = triple(glm::normalize(foot - top));
            text += (x + z) % 2 == 0
                        ? line("co", triple(top), down, "0.9", height, "50,125,200" + shiny)
                        : line("cy", triple((foot + top) / 2.0), up, "0.7", height,
                               "200,100,50" + shiny);
        }
    return text;
}

const PeerScene scenes[] = {
    {.name = "three_spheres", .what = "3 spheres, plane, hard shadow", .text = three_spheres},
    {.name = "cornell",
     .what = "Cornell box, 64 light samples",
     .size = {.width = 640, .height = 480},
     .effort = {.shadow_samples = 64},
     .text = cornell},
    {.name = "mirror_spheres",
     .what = "100 mirror spheres, depth 5",
     .effort = {.depth = 5},
     .text = mirror_spheres},
    {.name = "spheres_1k",
     .what = "1,000 spheres",
     .tachyon_bar = 1.5,
     .text = [] { return cloud(1000, 0.16, 0.6); }},
    {.name = "spheres_10k",
     .what = "10,000 spheres",
     .tachyon_bar = 1.5,
     .text = [] { return cloud(10'000, 0.08, 0.28); }},
    {.name = "mesh_70k", .what = "69,620 triangles", .text = [] { return mesh("sphere_70k"); }},
    {.name = "mesh_1m", .what = "1,003,520 triangles", .text = [] { return mesh("sphere_1m"); }},
    {.name = "cylinders_cones", .what = "cylinders and cones", .text = cylinders_and_cones},
};

}  // namespace

std::span<const PeerScene> peer_scenes() {
    return scenes;
}

std::string f32_text(double value) {
    std::array<char, 32> text{};
    char* const end = std::to_chars(text.begin(), text.end(), float(value)).ptr;
    return {text.begin(), end};
}

}  // namespace measurements
