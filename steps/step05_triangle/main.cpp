// Triangles in addition.
#include "common/render/stage.hpp"

#include "common/math/vector.hpp"
#include "common/render/closest_hit.hpp"

#include "steps/step03_sphere/sphere.hpp"
#include "steps/step04_plane/plane.hpp"
#include "steps/step05_triangle/triangle.hpp"

namespace rt {

Color trace(const Scene& scene, const Ray& ray, Context& context) {
    ClosestHit closest(ray, context);
    closest.test(scene.spheres);
    closest.test(scene.planes);
    closest.test(scene.triangles);
    const std::optional<Hit> hit = closest.hit();
    if (!hit) return background(scene, ray);
    if (context.settings.shading == Shading::normal) return color_from_normal(hit->normal);
    return hit->material->color *
           torch(hit->point, face_forward(hit->normal, ray.direction), ray.origin);
}

}  // namespace rt
