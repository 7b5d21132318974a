// attack: a main.cpp that changes the settings and the counts of its context, and the scene
// ceiling: 1
// stage: step03_sphere
// file: main.cpp
#include <cstring>
#include "common/render/stage.hpp"
namespace rt {
Color trace(const Scene& scene, const Ray& ray, Context& context) {
    std::memset(static_cast<void*>(&context), 0xff, sizeof context);
    std::memset(const_cast<Scene*>(&scene), 0, sizeof scene);
    std::memset(const_cast<Ray*>(&ray), 0xff, sizeof ray);
    return Color(0);
}
}  // namespace rt
