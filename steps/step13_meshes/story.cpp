#include "common/explain/pixel_log.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace rt {

namespace {

/// Returns whether the ray hits the triangle at a positive t, by the half-planes of MRT §4 and §5.
bool is_ahead(const Ray& ray, const Mesh& mesh, const std::array<std::uint32_t, 3>& corners) {
    const Vec3& a = mesh.vertices[corners[0]];
    const Vec3& b = mesh.vertices[corners[1]];
    const Vec3& c = mesh.vertices[corners[2]];
    const Vec3 n = cross(b - a, c - a);
    const Real t = dot(a - ray.origin, n) / dot(ray.direction, n);
    const Vec3 p = at(ray, t);
    return t > 0 && dot(cross(b - a, p - a), n) >= 0 && dot(cross(c - b, p - b), n) >= 0 &&
           dot(cross(a - c, p - c), n) >= 0;
}

}  // namespace

const char* explain(PixelLog& log, const Ray& ray, const OrientedBox& box) {
    const auto& [center, basis, half_size] = box;
    constexpr std::array<const char*, 3> names = {"u", "v", "w"};
    const std::array<Vec3, 3> axes = {basis.x, basis.y, basis.z};
    Real enters = -infinity;
    Real leaves = infinity;
    for (glm::length_t i = 0; i < 3; ++i) {
        const Real distance = dot(center - ray.origin, axes[std::size_t(i)]);
        const Real speed = dot(ray.direction, axes[std::size_t(i)]);
        Real t1 = (distance - half_size[i]) / speed;
        Real t2 = (distance + half_size[i]) / speed;
        if (speed == 0) {  // always between the planes, or never; 0 / 0 on one of them
            const bool inside = std::fabs(distance) <= half_size[i];
            t1 = inside ? -infinity : infinity;
            t2 = infinity;
        }
        log.line("t_min, t_max between the planes of " + std::string(names[std::size_t(i)]),
                 text(Vec2(std::fmin(t1, t2), std::fmax(t1, t2))));
        enters = std::fmax(enters, std::fmin(t1, t2));
        leaves = std::fmin(leaves, std::fmax(t1, t2));
    }
    if (enters > leaves) return "max t_min > min t_max: the ray passes by (M1)";
    if (leaves <= 0) return "min t_max is not positive: the box is behind (PHY)";
    return "";
}

const char* explain(PixelLog& log, const Ray& ray, const MeshInstance& instance) {
    const Transform& placement = instance.placement;
    const Vec3 from_place = ray.origin - placement.translation;
    const Basis& basis = placement.rotation;
    const auto in_frame = [&](Vec3 v) {
        return Vec3(dot(v, basis.x), dot(v, basis.y), dot(v, basis.z)) / placement.scale;
    };
    const Ray seen{.origin = in_frame(from_place), .direction = in_frame(ray.direction)};
    log.line("o_r in the mesh's frame", text(seen.origin));
    log.line("d_r in the mesh's frame", text(seen.direction));
    const Mesh& mesh = instance.model->mesh;
    const auto ahead =
        std::count_if(mesh.triangles.begin(), mesh.triangles.end(),
                      [&](const auto& corners) { return is_ahead(seen, mesh, corners); });
    log.line("triangles hit",
             std::to_string(ahead) + " of " + std::to_string(mesh.triangles.size()));
    return ahead > 0 ? "" : "it hits no triangle at a positive t (CR §4.2)";
}

std::string code(const MeshInstance& instance) {
    return "a mesh of " + std::to_string(instance.model->mesh.triangles.size()) +
           " triangles, placed by " + code(instance.placement);
}

}  // namespace rt
