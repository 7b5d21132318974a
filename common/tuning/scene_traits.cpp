#include "common/tuning/render_trials.hpp"

#include "common/stages/stages.hpp"
#include "common/tuning/input_rounding.hpp"

#include <algorithm>

namespace rt {

namespace {

template <class Shape>
std::size_t count(const Shape& /*shape*/) {
    return 1;
}
std::size_t count(const MeshInstance& instance) {
    return instance.model->mesh.triangles.size();
}

template <class Shape>
void take_in(SceneTraits& traits, const PrimitiveList<Shape>& primitives) {
    for (const auto& [shape, material] : primitives) {
        if (material.specular > 0)
            traits.shininess = std::max(traits.shininess, double(material.shininess));
        traits.strongest_mirror = std::max(traits.strongest_mirror, double(material.mirror));
        traits.shapes += count(shape);
    }
}

}  // namespace

SceneTraits scene_traits(const Scene& scene, int stage, const RenderSettings& settings) {
    SceneTraits traits{.lengths = scene_sizes(scene), .unit_roundoff = unit_roundoff};
    for_each_kind(scene, [&](const auto& primitives) { take_in(traits, primitives); });
    take_in(traits, scene.meshes);
    const bool lit = settings.shading == Shading::color && stage >= light_stage;
    if (!lit) {
        traits.strongest_mirror = 0;
        traits.shininess = 1;
    }
    traits.shadows = lit && stage > light_stage && !scene.lights.empty();
    traits.sized_lights = lit && std::ranges::any_of(scene.lights, [](const Light& light) {
                              return light.radius > 0;
                          });
    return traits;
}

}  // namespace rt
