// Makes the scenes of the gallery that have too many shapes to write by hand: `make_gallery NAME`
// writes the text of a scene to the standard output.
#include "scenes/gallery/scenes.hpp"

#include <iostream>
#include <string>

namespace {

struct Made {
    const char* name;
    std::string (*make)();
};

constexpr Made scenes[] = {
    {"step03_sphere", rt::sunflower},     {"step05_triangle", rt::mountains},
    {"step06_square", rt::wave_of_tiles}, {"step07_cylinder", rt::bamboo},
    {"step08_cone", rt::pencils},         {"step09_phong", rt::balloons},
    {"step12_mirror", rt::marbles},
};

}  // namespace

int main(int count, char** words) {
    const std::string wanted = count == 2 ? words[1] : "";
    for (const auto& [name, make] : scenes) {
        if (wanted == name) return std::cout << make() << std::flush ? 0 : 1;
        if (wanted == "--list") std::cout << name << '\n';
    }
    if (wanted == "--list") return 0;
    std::cerr << "error: expected make_gallery NAME, or make_gallery --list\n";
    return 2;
}
