#include "common/scene/scene.hpp"

namespace rt {

void build_acceleration(Scene& scene, const Acceleration& how) {
    // All hierarchies use one frame, so that a ray is prepared once for all kinds.
    BoundingBox all;
    const auto take_in = [&](const auto& primitives) {
        if (primitives.many(how)) all = merged(all, primitives.box());
    };
    const auto arrange_kind = [&](auto& primitives) { primitives.build_acceleration(how, all); };
    for_each_kind(scene, take_in);
    take_in(scene.meshes);
    for_each_kind(scene, arrange_kind);
    arrange_kind(scene.meshes);
}

}  // namespace rt
