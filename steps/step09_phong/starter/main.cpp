// Your trace of stage 9 (CR §3.1). This stage replaces the torch by the lights of the scene:
//
// shading_point(*hit, ray) is the point that the functions of "steps/step09_phong/phong.hpp" take.
// Fill a PhongTerms: the ambient term, if there is scene.ambient, and the diffuse and the specular
// term of each light of scene.lights. visible_sum(terms, context) is their sum.
#include "common/render/stage.hpp"

#include "common/math/vector.hpp"
#include "common/render/closest_hit.hpp"

#include "steps/step03_sphere/sphere.hpp"
#include "steps/step04_plane/plane.hpp"
#include "steps/step05_triangle/triangle.hpp"
#include "steps/step06_square/square.hpp"
#include "steps/step07_cylinder/cylinder.hpp"
#include "steps/step08_cone/cone.hpp"

namespace rt {

Color trace(const Scene& scene, const Ray& ray, Context& context) {
    ClosestHit closest(ray, context);
    closest.test(scene.spheres);
    closest.test(scene.planes);
    closest.test(scene.triangles);
    closest.test(scene.squares);
    closest.test(scene.cylinders);
    closest.test(scene.cones);
    const std::optional<Hit> hit = closest.hit();
    if (!hit) return background(scene, ray);
    if (context.settings.shading == Shading::normal) return color_from_normal(hit->normal);
    return hit->material->color *
           torch(hit->point, face_forward(hit->normal, ray.direction), ray.origin);
}

}  // namespace rt
