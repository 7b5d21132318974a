// origin: invented: a query for each list
// caught by: each kind of shape hides what is farther away, in any order of the file (CR §2.1)
// sentence: A mesh is seen only where nothing else is: one ClosestHit tests all lists, so that the closest of all counts.
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
    };
    ClosestHit closest(ray, context);
    everything(closest);
    std::optional<Hit> hit = closest.hit();
    if (!hit) {
        ClosestHit meshes(ray, context);
        meshes.test(scene.meshes);
        if (meshes.hit()) hit.emplace(*meshes.hit());
    }
    if (!hit) return background(scene, ray);
    if (context.settings.shading == Shading::normal) return color_from_normal(hit->normal);

    const ShadingPoint surface = shading_point(*hit, ray);
    const Real mirror = surface.material.mirror;
    const PhongTerms terms =
        mirror < 1 ? lighting(scene, surface, everything, context) : PhongTerms{};
    if (mirror == 0) return visible_sum(terms, context);

    const Color own = mirror < 1 ? visible_sum(terms, context) : Color(0);
    return mixed(own, reflection(scene, ray, surface, context), mirror);
}

}  // namespace rt
