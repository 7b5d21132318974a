// Mirrors, which reflect rays.
#include "common/render/stage.hpp"

#include "steps/step03_sphere/sphere.hpp"
#include "steps/step08_cone/all_shapes.hpp"
#include "steps/step11_soft_shadows/lighting.hpp"
#include "steps/step12_mirror/mirror.hpp"
#include "steps/step12_mirror/reflection.hpp"

namespace rt {

Color trace(const Scene& scene, const Ray& ray, Context& context) {
    Nearest nearest(ray, context);
    among_shapes(nearest, scene);
    const std::optional<Hit> hit = nearest.hit();
    if (!hit) return Color(0);
    if (context.look.shading == Shading::normal) return color_from_normal(hit->normal);

    const auto obstacles = [&](auto& query) { among_shapes(query, scene); };
    const Surface surface = surface_at(*hit, ray);
    const Real mirror = surface.material.mirror;
    const Terms terms = mirror < 1 ? lighting(scene, surface, obstacles, context) : Terms{};
    if (mirror == 0) return shown(terms, context);

    const Color own = mirror < 1 ? shown(terms, context) : Color(0);
    return mixed(own, reflection(scene, ray, surface, context), mirror);
}

}  // namespace rt
