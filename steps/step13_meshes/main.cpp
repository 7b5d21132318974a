// Meshes and boxes join: all that a scene can hold.
#include "common/stage.hpp"

#include "steps/step03_sphere/sphere.hpp"
#include "steps/step08_cone/all_shapes.hpp"
#include "steps/step11_soft_shadows/lighting.hpp"
#include "steps/step12_mirror/mirror.hpp"
#include "steps/step13_meshes/meshes.hpp"
#include "steps/step13_meshes/placed_mesh.hpp"

namespace rt {

namespace {

template <class Query>
void among_all(Query& query, const Scene& scene) {
    among_shapes(query, scene);
    query.among(scene.boxes);
    query.among(scene.meshes);
}

/// The colour along a ray that has been reflected `bounces` times and counts by `weight`.
Color color_along(const Scene& scene, const Ray& ray, int bounces, Real weight, Context& context) {
    Nearest nearest(ray, context);
    among_all(nearest, scene);
    const std::optional<Hit> hit = nearest.hit();
    if (!hit) return Color(0);
    if (context.look.shading == Shading::normal) return color_from_normal(hit->normal);

    const Surface surface = surface_at(*hit, ray);
    const Real mirror = surface.material.mirror;
    Color own(0);
    if (mirror < 1) own = shown(lighting(scene, surface, bounces, context), context);
    if (mirror == 0) return own;
    Color reflection(0);
    if (worth_reflecting(bounces, context.look.depth, weight * mirror))
        reflection =
            color_along(scene, mirrored(ray, surface), bounces + 1, weight * mirror, context);
    return mixed(own, reflection, mirror);
}

}  // namespace

bool blocked(const Scene& scene, const ShadowRay& way, Context& context) {
    Blocker blocker(way.ray, way.interval, context);
    among_all(blocker, scene);
    return blocker.found();
}

Color trace(const Scene& scene, const Ray& ray, Context& context) {
    return color_along(scene, ray, 0, 1, context);
}

}  // namespace rt
