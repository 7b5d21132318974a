// Squares join, among them those that are seen from one side only.
#include "common/nearest.hpp"
#include "common/stage.hpp"
#include "common/vector.hpp"

#include "steps/step01_ray_generation/ray_generation.hpp"
#include "steps/step02_camera_basis/camera_basis.hpp"
#include "steps/step03_sphere/sphere.hpp"
#include "steps/step04_plane/plane.hpp"
#include "steps/step05_triangle/triangle.hpp"
#include "steps/step06_square/square.hpp"

namespace rt {

std::function<Ray(Pixel)> pixel_rays(const Camera& camera, Resolution resolution) {
    const Real fov = vertical_fov(camera, resolution);
    const Basis basis = camera_basis(camera.direction);
    return [=, position = camera.position](Pixel pixel) {
        return to_world(camera_ray(pixel, resolution, fov), basis, position);
    };
}

Color trace(const Scene& scene, const Ray& ray, Context& context) {
    Nearest nearest(ray, context);
    nearest.among(scene.spheres);
    nearest.among(scene.planes);
    nearest.among(scene.triangles);
    nearest.among(scene.squares);
    const std::optional<Hit> hit = nearest.hit();
    if (!hit) return Color(0);
    if (context.shading == Shading::normal) return color_from_normal(hit->normal);
    return hit->material->color * torch(hit->point, facing(hit->normal, ray.direction), ray.origin);
}

}  // namespace rt
