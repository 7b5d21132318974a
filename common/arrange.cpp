#include "common/scene.hpp"

namespace rt {

void arrange(Scene& scene) {
    for_each_kind(scene, [](auto& items) { items.arrange(); });
    scene.meshes.arrange();
}

}  // namespace rt
