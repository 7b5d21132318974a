// One scene, moved away from 0, scaled, and with a shrinking gap between two surfaces: the number
// of pixels that change in float and double. The exact picture does not change at all.
#include "tests/measurements/accuracy/drawing.hpp"

#include <unistd.h>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <string_view>

using namespace rt;

namespace {

constexpr Resolution size{.width = 240, .height = 180};

struct Change {
    const char* name = "";
    double at = 0;
    double transformed = 0;
    double scale = 1;
    double gap = 0.1;
};

/// Shadows, a highlight, six kinds of shape, and a card that lies on another.
std::string scene_text(const Change& change) {
    const auto number = [](double value) {
        std::array<char, 32> text;
        std::snprintf(text.data(), text.size(), "%.17g", value);
        return std::string(text.data());
    };
    const auto length = [&](double value) { return number(change.scale * value) + " "; };
    const auto point = [&](double x, double y, double z) {
        const auto transformed = [&](double value) {
            return number(change.scale * value + change.transformed);
        };
        return transformed(x) + "," + transformed(y) + "," + transformed(z) + " ";
    };
    return "A 0.16 255,255,255\nC " + point(0.1, 2.3, 7) + "-0.015,-0.27,-1 43\nL " +
           point(-4.5, 5.2, 3.4) + "0.7 255,196,130\nL " + point(5.2, 4.4, 2.6) +
           "0.58 130,185,255\npl " + point(0, -1, 0) + "0,1,0 225,222,215\nsp " +
           point(-1.7, 0, 0.1) + length(2) + "220,70,55 spec:0.5 shin:40\nco " +
           point(1.15, 1.45, 0.6) + "0.02,-1,0.01 " + length(1.5) + length(2.43) +
           "95,190,125\ncy " + point(0.2, 0.35, -1.6) + "0,1,0.03 " + length(0.9) + length(2.68) +
           "235,185,60\ntr " + point(-4.3, -0.98, -1.2) + point(-2.7, -0.98, -2.1) +
           point(-3.6, 1.7, -1.9) + "90,150,200\nsq " + point(0, -0.8, 2.2) + "0,1,0 " +
           length(1.6) + "120,95,170\nsq " + point(0, -0.8 + change.gap, 2.2) + "0,1,0 " +
           length(1) + "240,236,120\n";
}

/// Drawn through a file of this process alone.
template <class Draw>
Drawing picture_of(const Change& change, const Draw& draw) {
    const auto file = std::filesystem::temp_directory_path() /
                      ("input_rounding." + std::to_string(getpid()) + ".rt");
    std::ofstream(file) << scene_text(change);
    Drawing drawing = draw(file.string(), size, RenderSettings{});
    std::filesystem::remove(file);
    return drawing;
}

std::vector<Change> changes() {
    std::vector<Change> all;
    for (int power = 1; power <= 12; ++power)
        all.push_back(
            {.name = "moved", .at = std::pow(10, power), .transformed = std::pow(10, power)});
    for (int power = -12; power <= 12; power += 3)
        all.push_back({.name = "scaled", .at = std::pow(10, power), .scale = std::pow(10, power)});
    for (int power = -1; power >= -16; --power)
        all.push_back({.name = "gap", .at = std::pow(10, power), .gap = std::pow(10, power)});
    return all;
}

void print(const Change& change, const char* precision, const Drawing& drawing,
           const Drawing& right) {
    const Difference off = difference(drawing.image, right.image);
    std::printf("%s,%g,%s,%.4g,%d,%.5f,%.5f\n", change.name, change.at, precision, off.error,
                off.most, off.other, off.seen);
}

}  // namespace

int main() {
    const Drawing unchanged = picture_of({}, f64::rendered);
    // So thin that it moves no edge of the picture, and easy for double.
    const Drawing thin = picture_of({.gap = 1e-9}, f64::rendered);
    constexpr double visible = 2e-5;
    std::puts("change,at,precision,error,most,other,seen");
    for (const Change& change : changes()) {
        const Drawing in_double = picture_of(change, f64::rendered);
        const bool has_own_gap = std::string_view(change.name) == "gap";
        const Drawing& right = !has_own_gap ? unchanged : change.gap > visible ? in_double : thin;
        print(change, "float", picture_of(change, f32::rendered), right);
        print(change, "double", in_double, right);
    }
}
