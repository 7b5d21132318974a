#include "common/scene.hpp"

namespace rt {

void arrange(Scene& scene) {
    scene.spheres.arrange();
    scene.triangles.arrange();
    scene.squares.arrange();
    scene.cylinders.arrange();
    scene.cones.arrange();
    scene.boxes.arrange();
    scene.meshes.arrange();
}

}  // namespace rt
