#include "common/requirements.hpp"

namespace rt {

std::vector<Requirement> requirements(const Scene& scene) {
    std::vector<Requirement> found;
    const auto require = [&found](std::size_t count, const std::string& name, int stage) {
        if (count == 0) return;
        found.push_back(
            {.what = std::to_string(count) + " " + name + (count > 1 ? "s" : ""), .stage = stage});
    };
    require(scene.spheres.size(), "sphere", 3);
    require(scene.planes.size(), "plane", 4);
    require(scene.triangles.size(), "triangle", 5);
    require(scene.squares.size(), "square", 6);
    require(scene.cylinders.size(), "cylinder", 7);
    require(scene.cones.size(), "cone", 8);
    return found;
}

}  // namespace rt
