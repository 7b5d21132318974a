// Soft shadows of area lights.
#include "common/render/stage.hpp"

#include "steps/step03_sphere/sphere.hpp"
#include "steps/step08_cone/all_shapes.hpp"
#include "steps/step11_soft_shadows/lighting.hpp"

namespace rt {

Color trace(const Scene& scene, const Ray& ray, Context& context) {
    Nearest nearest(ray, context);
    among_shapes(nearest, scene);
    const std::optional<Hit> hit = nearest.hit();
    if (!hit) return Color(0);
    if (context.look.shading == Shading::normal) return color_from_normal(hit->normal);

    const auto obstacles = [&](auto& query) { among_shapes(query, scene); };
    return shown(lighting(scene, surface_at(*hit, ray), obstacles, context), context);
}

}  // namespace rt
