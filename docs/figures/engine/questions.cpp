#include "docs/figures/engine/questions.hpp"

#include "scenes/meshes/owl.hpp"

#include "common/bvh/bvh.hpp"
#include "common/explain/pixel_log.hpp"
#include "common/image/to_rgb.hpp"
#include "common/math/vector.hpp"
#include "common/render/closest_hit.hpp"
#include "common/render/sampling.hpp"

#include <glm/common.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <sstream>

namespace rt::book {

namespace {

template <class Write>
Text written(Write write) {
    std::ostringstream out;
    PixelLog log(out);
    write(log);
    const std::string text = out.str();
    return {text.begin(), text.end()};
}

}  // namespace

template <class Shape>
Text explain_shape(const Ray& ray, const Shape& shape, Interval interval) {
    return written([&](PixelLog& log) {
        explain_candidate(log, ray, shape, interval, intersect(ray, shape, interval), [&] {
            return intersect(ray, shape, {.min = interval.min, .max = infinity});
        });
    });
}

template Text explain_shape(const Ray& ray, const Sphere& shape, Interval interval);
template Text explain_shape(const Ray& ray, const Plane& shape, Interval interval);
template Text explain_shape(const Ray& ray, const Triangle& shape, Interval interval);
template Text explain_shape(const Ray& ray, const Square& shape, Interval interval);
template Text explain_shape(const Ray& ray, const Cylinder& shape, Interval interval);
template Text explain_shape(const Ray& ray, const Cone& shape, Interval interval);
template Text explain_shape(const Ray& ray, const OrientedBox& shape, Interval interval);

Text explain_screen(Pixel pixel, Resolution resolution, Real vertical_fov) {
    return written(
        [&](PixelLog& log) { rt::explain_screen(log, pixel, resolution, vertical_fov); });
}

Text explain_light(const ShadingPoint& surface, const Light& light) {
    return written([&](PixelLog& log) { explain(log, surface, light); });
}

Mat4 image_to_world(Resolution resolution, Real vertical_fov, Real near, Real far) {
    const Real width = Real(resolution.width);
    const Real height = Real(resolution.height);
    // −1 to 1 becomes 0 to W from the left, 0 to H from the top, 0 to 1 from the near plane.
    const Mat4 image = glm::translate(Mat4(1), Vec3(width / 2, height / 2, Real(0.5))) *
                       glm::scale(Mat4(1), Vec3(width / 2, -height / 2, Real(0.5)));
    const Mat4 projection = glm::perspective(vertical_fov, width / height, near, far);
    return glm::inverse(projection) * glm::inverse(image);
}

Basis printed_basis(Vec3 direction) {
    const Vec3 z = unit(-direction);
    const Vec3 x = cross(Vec3(0, 1, 0), z);
    return {.x = x, .y = cross(z, x), .z = z};
}

std::optional<Real> intersect_with_epsilon(const Ray& ray, const Plane& plane, Interval interval,
                                           Real epsilon) {
    const Real approach = dot(ray.direction, plane.normal);
    if (std::abs(approach) < epsilon) return std::nullopt;
    const Real t = dot(plane.point - ray.origin, plane.normal) / approach;
    if (!interval.contains(t)) return std::nullopt;
    return t;
}

template <class Shape>
std::optional<ShadingPoint> shade(const Ray& ray, const Shape& shape) {
    const auto t = intersect(ray, shape, Interval{});
    if (!t) return std::nullopt;
    const PointWithError place = snapped_to(shape, at(ray, *t));
    const Vec3 outward = normal(shape, place.point);
    return shading_point(Hit(*t, place, outward, outward, Material{}), ray);
}

template std::optional<ShadingPoint> shade(const Ray& ray, const Sphere& shape);
template std::optional<ShadingPoint> shade(const Ray& ray, const Plane& shape);
template std::optional<ShadingPoint> shade(const Ray& ray, const Triangle& shape);

ShadowRay printed_shadow_ray(const ShadingPoint& surface, Vec3 light, Real epsilon) {
    const Vec3 way = light - surface.point;
    const Real distance = std::sqrt(dot(way, way));
    return {.ray = {.origin = surface.point, .direction = way / distance},
            .interval = {.min = epsilon, .max = distance}};
}

Vec2 well_spread_sample(std::uint32_t index, std::uint32_t seed) {
    return spread_sample(index, seed);
}

Vec2 independent_sample(std::uint32_t index, std::uint32_t seed) {
    // Each point is the first one of a sequence of its own.
    return spread_sample(0, sample_seed({.row = int(index), .column = int(seed)}, 1, 0));
}

std::vector<std::uint8_t> lit_ball(const Light& light, const Ambient& ambient,
                                   const Material& material, Vec3 to_eye, std::uint32_t side) {
    const Sphere ball{.center = Vec3(0), .radius = 1};
    const Vec3 up(-to_eye.y, to_eye.x, 0);
    const Vec3 right = cross(up, to_eye);
    std::vector<std::uint8_t> pixels;
    for (std::uint32_t row = 0; row < side; ++row)
        for (std::uint32_t column = 0; column < side; ++column) {
            const Real x = (Real(2 * column + 1) - Real(side)) / Real(side);
            const Real y = (Real(side) - Real(2 * row + 1)) / Real(side);
            auto surface = shade(
                Ray{.origin = x * right + y * up + Real(3) * to_eye, .direction = -to_eye}, ball);
            Color color(0);
            if (surface) {
                surface->material = material;
                color = ambient_term(*surface, ambient) + diffuse_term(*surface, light) +
                        specular_term(*surface, light);
            }
            const auto [red, green, blue] = to_rgb(color);
            pixels.insert(pixels.end(), {blue, green, red, std::uint8_t(surface ? 255 : 0)});
        }
    return pixels;
}

Vec3 share_and_errors(const Light& light, const Sphere& ball, std::uint32_t count) {
    const Vec3 up(0, 1, 0);
    const ShadingPoint from{
        .point = Vec3(0), .normal = up, .geometric_normal = up, .to_eye = up, .material = {}};
    const auto seen = [&](auto sample, std::uint32_t seed, std::uint32_t sent) {
        ShadowRays rays{.sent = int(sent)};
        for (std::uint32_t i = 0; i < sent; ++i) {
            const ShadowRay way =
                shadow_ray(from, sample_light(light, from.point, sample(i, seed)));
            if (!intersect(way.ray, ball, way.interval)) ++rays.reached;
        }
        return visibility(rays);
    };
    const Real share = seen(well_spread_sample, 0, 1U << 13);
    Vec2 sums(0);
    for (std::uint32_t seed = 1; seed <= 64; ++seed) {
        const Vec2 off(seen(well_spread_sample, seed, count) - share,
                       seen(independent_sample, seed, count) - share);
        sums += off * off;
    }
    return {share, std::sqrt(sums.x / 64), std::sqrt(sums.y / 64)};
}

Mesh owl() {
    const Polygons cage = cut_up(owl_cage());
    Mesh mesh;
    // To four digits, as in the file: C libraries differ in the last bit of a cosine.
    for (const glm::dvec3& vertex : cage.vertices)
        mesh.vertices.emplace_back(glm::round(vertex * 1e4) / 1e4);
    for (const std::vector<int>& face : cage.faces)
        mesh.triangles.push_back(
            {std::uint32_t(face[0]), std::uint32_t(face[1]), std::uint32_t(face[2])});
    return mesh;
}

std::vector<HierarchyBox> owl_hierarchy() {
    const Mesh mesh = owl();
    const auto box_of = [&mesh](std::size_t triangle) {
        BoundingBox box;
        for (const std::uint32_t corner : mesh.triangles[triangle])
            box = merged(box, mesh.vertices[corner]);
        return box;
    };
    const Bvh hierarchy(mesh.triangles.size(), box_of, Bvh::Leaves::packed);
    std::vector<HierarchyBox> boxes;
    for (const Bvh::Part& part : hierarchy.parts()) {
        boxes.push_back({.box = {}, .parent = std::uint32_t(part.parent), .triangles = {}});
        if (!part.leaf) continue;
        for (const std::uint32_t triangle : hierarchy.leaves()[*part.leaf].indices)
            if (triangle != Leaf::none) boxes.back().triangles.push_back(triangle);
    }
    for (std::size_t place = boxes.size(); place-- > 0;) {
        auto& [box, parent, triangles] = boxes[place];
        for (const std::uint32_t triangle : triangles) box = merged(box, box_of(triangle));
        if (place > 0) boxes[parent].box = merged(boxes[parent].box, box);
    }
    return boxes;
}

}  // namespace rt::book
