// origin: invented: 1e30 for infinity
// caught by: each kind of shape hides what is farther away, in any order of the file (CR §2.1)
// sentence: You ignore hits beyond a constant. A hit may be at any distance: an Interval ends at infinity.
#include "common/math/vector.hpp"
#include "common/render/closest_hit.hpp"
#include "common/render/stage.hpp"

#include "steps/step03_sphere/sphere.hpp"
#include "steps/step04_plane/plane.hpp"

namespace rt {

Color trace(const Scene& scene, const Ray& ray, Context& context) {
    ClosestHit closest(ray, context);
    closest.test(scene.spheres);
    closest.test(scene.planes);
    const std::optional<Hit> hit = closest.hit();
    if (!hit || hit->t > Real(1e30)) return background(scene, ray);
    if (context.settings.shading == Shading::normal) return color_from_normal(hit->normal);
    return hit->material->color *
           torch(hit->point, face_forward(hit->normal, ray.direction), ray.origin);
}

}  // namespace rt
