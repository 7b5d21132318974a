#include "common/program/make_picture.hpp"

#include "common/explain/ray_records.hpp"
#include "common/explain/text.hpp"
#include "common/geometry/shape_formulas.hpp"
#include "common/image/color_scale.hpp"
#include "common/math/vector.hpp"
#include "common/program/outlines.hpp"
#include "common/render/pixel_values.hpp"
#include "common/scene/scene.hpp"
#include "common/system/text.hpp"

#include <array>
#include <cmath>
#include <set>
#include <type_traits>
#include <vector>

namespace rt {

namespace {

constexpr std::size_t most_outlines = 300;  ///< in addition to the shapes that rays hit

Vec3 vector(const Numbers& numbers) {
    return {Real(numbers[0]), Real(numbers[1]), Real(numbers[2])};
}

/// The value of a JSON member that is a list of vectors.
std::string list(const std::vector<Vec3>& vectors) {
    const auto number = [](Real x) {
        return std::isfinite(x) ? formatted("%.5g", double(x)) : "null";
    };
    const auto numbers = [&](Vec3 v) { return joined(std::array{v.x, v.y, v.z}, number, ","); };
    return "[" + joined(vectors, numbers, ",") + "]";
}

/// The box of what is drawn: shapes, camera, lights, hits, and the places of planes near to them.
BoundingBox box_of_drawing(const Scene& scene, const RayRecords& records) {
    BoundingBox box = merged(box_of_shapes(scene), scene.cameras.front().position);
    for (const Light& light : scene.lights) box = merged(box, light.position);
    for (const RayRecord& ray : records.rays)
        if (ray.point) box = merged(box, vector(*ray.point));
    const Vec3 middle = (box.min + box.max) / Real(2);
    const Real size = length(box.max - box.min);
    for (const auto& [plane, material] : scene.planes) {
        const Vec3 place = geometry::onto_plane(middle, plane.point, unit(plane.normal));
        if (length(place - middle) < size) box = merged(box, place);
    }
    const Vec3 margin(length(box.max - box.min) / 100);
    return {.min = box.min - margin, .max = box.max + margin};
}

/// The outline of the shape; that of a plane ends at the box.
template <class Shape>
Segments outline_in(const BoundingBox& box, const Shape& shape) {
    if constexpr (std::is_same_v<Shape, Plane>)
        return outline(shape, box);
    else
        return outline(shape);
}

/// What the ray hits, in words, with the numbers of `--pixel`.
std::string words(const RayRecord& ray, const std::optional<int>& shape, const Scene& scene) {
    const std::string name = shape ? name_of_shape(*shape, scene) : "a shape";
    if (ray.kind == RayKind::shadow) {
        if (!ray.shape) return "reaches the light";
        return "blocked by " + name + (ray.t ? " at t = " + text(Real(*ray.t)) : "");
    }
    if (!ray.t) return "hits nothing";
    return "hits " + name + " at t = " + text(Real(*ray.t)) +
           (ray.point ? ", p = " + text(vector(*ray.point)) : "");
}

std::string kind_name(RayKind kind) {
    return kind == RayKind::eye ? "eye" : kind == RayKind::mirrored ? "mirrored" : "shadow";
}

/// A ray as JSON: its kind, whether it hits a shape, its ends, and the end of the rest of its way:
/// to the light, if a shape blocks it.
std::string ray_text(const RayRecord& ray, const Scene& scene, Real far) {
    const Vec3 origin = vector(ray.origin);
    const Vec3 direction = vector(ray.direction);
    const Real unhindered = std::isfinite(ray.end) ? Real(ray.end) : far / length(direction);
    const Vec3 rest = origin + unhindered * direction;
    const bool hits = ray.shape != nullptr;
    const Vec3 end = ray.point ? vector(*ray.point)
                     : ray.t   ? origin + Real(*ray.t) * direction
                               : rest;
    const auto shape = number_of(ray.shape, scene);
    std::string json = R"({"kind":")" + kind_name(ray.kind) + R"(","bounces":)" +
                       std::to_string(ray.bounces) + R"(,"hits":)" + (hits ? "true" : "false") +
                       R"(,"way":)" + list({origin, end}) + R"(,"words":")" +
                       words(ray, shape, scene) + R"(")";
    if (hits && ray.kind == RayKind::shadow) json += R"(,"rest":)" + list({end, rest});
    if (ray.point) json += R"(,"normal":)" + list({end, end + far / 20 * vector(ray.normal)});
    return json + "}";
}

}  // namespace

std::string ray_drawing(const Scene& scene, const RenderSettings& settings, Pixel pixel) {
    const Camera& camera = scene.cameras.front();
    const PixelRays pixel_ray = pixel_rays(camera, scene.resolution);
    const RayRecords records =
        trace_records(scene, pixel_ray(pixel), {.settings = settings, .pixel = pixel});
    const BoundingBox box = box_of_drawing(scene, records);
    const Real size = length(box.max - box.min);

    std::string rays;
    std::set<int> hit;
    for (const RayRecord& ray : records.rays) {
        rays += (rays.empty() ? "" : ",") + ray_text(ray, scene, size);
        if (const auto shape = number_of(ray.shape, scene)) hit.insert(*shape);
    }

    std::string outlines;
    int number = 0;
    std::size_t left_out = 0;
    const auto draw = [&](const auto& primitives) {
        for (const auto& primitive : primitives) {
            const int shape = number++;
            const bool is_hit = hit.contains(shape);
            if (!is_hit && std::size_t(shape) >= most_outlines) {
                ++left_out;
                continue;
            }
            std::vector<Vec3> segments;
            for (const auto& [from, to] : outline_in(box, primitive.shape))
                segments.insert(segments.end(), {from, to});
            outlines += std::string(outlines.empty() ? "" : ",") + R"({"shape":")" +
                        name_of_shape(shape, scene) + R"(","hit":)" + (is_hit ? "true" : "false") +
                        R"(,"color":")" + hex(distinct_color(shape)) + R"(","segments":)" +
                        list(segments) + "}";
        }
    };
    for_each_kind(scene, draw);
    draw(scene.meshes);

    // The camera: the pyramid from its position through the corners of the picture.
    std::vector<Vec3> frame;
    const int right = scene.resolution.width - 1;
    const int bottom = scene.resolution.height - 1;
    for (const Pixel& corner :
         {Pixel{0, 0}, Pixel{0, right}, Pixel{bottom, right}, Pixel{bottom, 0}}) {
        const Ray ray = pixel_ray(corner);
        frame.push_back(ray.origin + size / 10 * unit(ray.direction));
    }
    const auto light_text = [](const Light& light) {
        return R"({"at":)" + list({light.position}) + R"(,"radius":)" + text(light.radius) + "}";
    };

    return R"({"rays":[)" + rays + R"(],"outlines":[)" + outlines + R"(],"left_out":)" +
           std::to_string(left_out) + R"(,"eye":)" + list({camera.position}) + R"(,"facing":)" +
           list({camera.direction}) + R"(,"frame":)" + list(frame) + R"(,"lights":[)" +
           joined(scene.lights, light_text, ",") + R"(],"box":)" + list({box.min, box.max}) + "}";
}

}  // namespace rt
