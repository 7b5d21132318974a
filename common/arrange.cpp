#include "common/scene.hpp"

namespace rt {

void arrange(Scene& scene, std::size_t pays_from) {
    for_each_kind(scene, [=](auto& items) { items.arrange(pays_from); });
    scene.meshes.arrange(pays_from);
}

}  // namespace rt
