// origin: a student's: one-sided squares are skipped
// caught by: each kind of shape hides what is farther away, in any order of the file (CR §2.1)
// sentence: You leave out one-sided squares: they are seen from their front. scene.squares decides that itself.
#include "common/render/stage.hpp"

#include "common/math/vector.hpp"
#include "common/render/closest_hit.hpp"

#include "steps/step03_sphere/sphere.hpp"
#include "steps/step04_plane/plane.hpp"
#include "steps/step05_triangle/triangle.hpp"
#include "steps/step06_square/square.hpp"

namespace rt {

Color trace(const Scene& scene, const Ray& ray, Context& context) {
    ClosestHit closest(ray, context);
    closest.test(scene.spheres);
    closest.test(scene.planes);
    closest.test(scene.triangles);
    PrimitiveList<Square> two_sided;
    for (const Primitive<Square>& each : scene.squares)
        if (!each.shape.one_sided) two_sided.push_back(each);
    closest.test(two_sided);
    const std::optional<Hit> hit = closest.hit();
    if (!hit) return background(scene, ray);
    if (context.settings.shading == Shading::normal) return color_from_normal(hit->normal);
    return hit->material->color *
           torch(hit->point, face_forward(hit->normal, ray.direction), ray.origin);
}

}  // namespace rt
