// Spheres, and the closest hit among them.
#include "common/math/vector.hpp"
#include "common/render/closest_hit.hpp"
#include "common/render/stage.hpp"

#include "steps/step03_sphere/sphere.hpp"

namespace rt {

Color trace(const Scene& scene, const Ray& ray, Context& context) {
    Nearest nearest(ray, context);
    nearest.among(scene.spheres);
    const std::optional<Hit> hit = nearest.hit();
    if (!hit) return Color(0);
    if (context.look.shading == Shading::normal) return color_from_normal(hit->normal);
    return hit->material->color * torch(hit->point, facing(hit->normal, ray.direction), ray.origin);
}

}  // namespace rt
