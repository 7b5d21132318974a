#include "common/scene/scene.hpp"

namespace rt {

void arrange(Scene& scene, const Arrangement& how) {
    // All hierarchies use one frame, so that a ray is prepared once for all kinds.
    Box all;
    const auto take_in = [&](const auto& items) {
        if (items.many(how)) all = united(all, items.box());
    };
    const auto arrange_kind = [&](auto& items) { items.arrange(how, all); };
    for_each_kind(scene, take_in);
    take_in(scene.meshes);
    for_each_kind(scene, arrange_kind);
    arrange_kind(scene.meshes);
}

}  // namespace rt
