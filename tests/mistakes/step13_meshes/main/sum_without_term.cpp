// origin: invented: visible_sum is not used
// caught by: the terms of all lights add up, from any eye, and --term selects one (CR §3.1)
// sentence: You add the terms yourself: --term has no effect. visible_sum selects.
#include "common/render/stage.hpp"

#include "steps/step03_sphere/sphere.hpp"
#include "steps/step08_cone/all_shapes.hpp"
#include "steps/step11_soft_shadows/lighting.hpp"
#include "steps/step12_mirror/mirror.hpp"
#include "steps/step12_mirror/reflection.hpp"
#include "steps/step13_meshes/mesh_instance.hpp"
#include "steps/step13_meshes/meshes.hpp"

namespace rt {

Color trace(const Scene& scene, const Ray& ray, Context& context) {
    const auto everything = [&](auto& query) {
        visit_shapes(query, scene);
        query.test(scene.boxes);
        query.test(scene.meshes);
    };
    ClosestHit closest(ray, context);
    everything(closest);
    const std::optional<Hit> hit = closest.hit();
    if (!hit) return background(scene, ray);
    if (context.settings.shading == Shading::normal) return color_from_normal(hit->normal);

    const ShadingPoint surface = shading_point(*hit, ray);
    const Real mirror = surface.material.mirror;
    const PhongTerms terms =
        mirror < 1 ? lighting(scene, surface, everything, context) : PhongTerms{};
    const Color sum = terms.ambient + terms.diffuse + terms.specular;
    if (mirror == 0) return sum;

    const Color own = mirror < 1 ? sum : Color(0);
    return mixed(own, reflection(scene, ray, surface, context), mirror);
}

}  // namespace rt
