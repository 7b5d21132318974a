// origin: invented: seen, but not in the way
// caught by: boxes and meshes cast shadows (CR §3.2)
// sentence: Boxes are seen, but cast no shadow: the shadow rays must test the same lists.
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
        query.test(scene.meshes);
    };
    ClosestHit closest(ray, context);
    everything(closest);
    closest.test(scene.boxes);
    const std::optional<Hit> hit = closest.hit();
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
