// origin: invented: the direction of the camera in the first scenes for that of the ray
// caught by: every kind of shape so far is seen (M1, "plusieurs objets")
// sentence: You turn the normal to one side of the scene. Turn it to the eye: face_forward(normal, ray.direction).
#include "common/math/vector.hpp"
#include "common/render/stage.hpp"
#include "steps/step03_sphere/sphere.hpp"
#include "steps/step04_plane/plane.hpp"
#include "steps/step05_triangle/triangle.hpp"
namespace rt {
namespace {
struct Found {
    Real t = infinity;
    Vec3 normal;
    Material material;
    bool any = false;
};
template <class List>
void look(const Ray& ray, const List& list, Found& found) {
    for (const auto& each : list) {
        const auto t = intersect(ray, each.shape, Interval{});
        if (!t) continue;
        if (!(*t < found.t)) continue;
        found.t = *t;
        found.normal = face_forward(normal(each.shape, at(ray, *t)), Vec3(0, 0, -1));
        found.material = each.material;
        found.any = true;
    }
}
}  // namespace
Color trace(const Scene& scene, const Ray& ray, Context& context) {
    ++context.rays;
    Found found;
    look(ray, scene.spheres, found);
    look(ray, scene.planes, found);
    look(ray, scene.triangles, found);
    if (!found.any) return background(scene, ray);
    if (context.settings.shading == Shading::normal) return color_from_normal(found.normal);
    return found.material.color * torch(at(ray, found.t), found.normal, ray.origin);
}
}  // namespace rt
