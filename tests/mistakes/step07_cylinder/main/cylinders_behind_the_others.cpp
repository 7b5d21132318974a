// origin: invented: a query for each list
// caught by: each kind of shape hides what is farther away, in any order of the file (CR §2.1)
// sentence: You query the cylinders only if no other shape is hit. One ClosestHit tests all lists, so that the closest of all counts.
#include "common/math/vector.hpp"
#include "common/render/closest_hit.hpp"
#include "common/render/stage.hpp"

#include "steps/step03_sphere/sphere.hpp"
#include "steps/step04_plane/plane.hpp"
#include "steps/step05_triangle/triangle.hpp"
#include "steps/step06_square/square.hpp"
#include "steps/step07_cylinder/cylinder.hpp"

namespace rt {

Color trace(const Scene& scene, const Ray& ray, Context& context) {
    ClosestHit closest(ray, context);
    closest.test(scene.spheres);
    closest.test(scene.planes);
    closest.test(scene.triangles);
    closest.test(scene.squares);
    std::optional<Hit> hit = closest.hit();
    if (!hit) {
        ClosestHit others(ray, context);
        others.test(scene.cylinders);
        hit = others.hit();
    }
    if (!hit) return background(scene, ray);
    if (context.settings.shading == Shading::normal) return color_from_normal(hit->normal);
    return hit->material->color *
           torch(hit->point, face_forward(hit->normal, ray.direction), ray.origin);
}

}  // namespace rt
