#include "common/tuning/fine_shapes.hpp"

#include "common/render/sampling.hpp"
#include "common/render/stage.hpp"
#include "common/scene/surface_points.hpp"
#include "common/tuning/wording.hpp"

#include <algorithm>
#include <cmath>

namespace rt {

namespace {

template <class Shape>
Real width(const Shape& shape) {
    if constexpr (requires { shape.radius; })
        return 2 * smallest_size(shape);
    else
        return smallest_size(shape);
}

/// A point in the picture, in pixels from its corner.
struct Place {
    double x = 0;
    double y = 0;
    double scale = 0;  ///< pixels for each unit of length at its depth; negative behind the camera
};

class Finder {
public:
    explicit Finder(const Scene& scene)
        : size_(scene.resolution),
          view_(pixel_rays(scene.cameras.front(), size_)),
          pixels_in_unit_(size_.height / (2 * std::tan(double(view_.vertical_fov) / 2))),
          fine_{.parts =
                    std::vector<float>(std::size_t(size_.width) * std::size_t(size_.height), 1)} {}

    template <class Shape>
    void take(const Shape& shape, Real width, const char* name) {
        const BoundingSphere ball = bounding_sphere(shape);
        const Place center = place(ball.center);
        const auto radius = double(ball.radius);
        const double nearest = pixels_in_unit_ / center.scale - radius;
        if (center.scale < 0 && radius < -pixels_in_unit_ / center.scale) return;
        const double farthest = nearest + 2 * radius;
        if (double(width) * pixels_in_unit_ / farthest >= 1) return;
        const bool is_dot = nearest > 0 && radius * center.scale < 0.5;
        if (is_dot) return mark(center, double(width), 2 * radius, radius * center.scale, name);
        const double most = 4.0 * (size_.width + size_.height);
        const double length = nearest > 0 ? 2 * radius * pixels_in_unit_ / nearest : most;
        const auto points = std::uint32_t(std::ceil(4 * std::min(length, most)));
        for (std::uint32_t i = 0; i < points; ++i) {
            const Place point = place(surface_point(shape, spread_sample(i, 0)));
            mark(point, double(width), 2 * radius, 0.25, name);
        }
    }

    [[nodiscard]] FineShapes found() && {
        if (fine_.narrowest.empty()) return {};
        return std::move(fine_);
    }

private:
    [[nodiscard]] Place place(Vec3 point) const {
        const Vec3 way = point - view_.position;
        const double scale = -pixels_in_unit_ / double(dot(way, view_.basis.z));
        return {.x = size_.width / 2.0 + double(dot(way, view_.basis.x)) * scale,
                .y = size_.height / 2.0 - double(dot(way, view_.basis.y)) * scale,
                .scale = scale};
    }

    /// Marks the pixels within `reach` pixels of a point of a shape.
    void mark(const Place& point, double width, double length, double reach, const char* name) {
        const double pixels = width * point.scale;
        if (!(0 <= pixels && pixels < 1)) return;
        const auto part = float(pixels * std::min(length * point.scale, 1.0) / 2);
        const auto clipped = [](double value, int size) {
            return int(std::clamp(std::floor(value), 0.0, double(size)));
        };
        const int last_column = clipped(point.x + reach + 1, size_.width);
        const int last_row = clipped(point.y + reach + 1, size_.height);
        for (int row = clipped(point.y - reach, size_.height); row < last_row; ++row)
            for (int column = clipped(point.x - reach, size_.width); column < last_column;
                 ++column) {
                float& least =
                    fine_.parts[std::size_t(row) * std::size_t(size_.width) + std::size_t(column)];
                least = std::min(least, part);
                if (!fine_.narrowest.empty() && pixels >= fine_.width) continue;
                fine_.width = pixels;
                fine_.narrowest = name;
            }
    }

    Resolution size_;
    PixelRays view_;
    double pixels_in_unit_;
    FineShapes fine_;
};

void take(Finder& finder, const MeshInstance& instance) {
    const Mesh& mesh = instance.model->mesh;
    const Real typical = smallest_size(instance);
    for (const auto& [a, b, c] : mesh.triangles) {
        const auto corner = [&](std::uint32_t i) {
            return transformed(mesh.vertices[i], instance.placement);
        };
        finder.take(Triangle{corner(a), corner(b), corner(c)}, typical, "triangle of a mesh");
    }
}

}  // namespace

FineShapes fine_shapes(const Scene& scene) {
    Finder finder(scene);
    const auto visit = [&](const auto& kind) {
        for (const auto& primitive : scene.*kind.primitives)
            if constexpr (requires { bounds(primitive.shape); })
                finder.take(primitive.shape, width(primitive.shape), kind.one);
    };
    std::apply([&](const auto&... kind) { (visit(kind), ...); }, shape_kinds);
    for (const auto& instance : scene.meshes) take(finder, instance.shape);
    return std::move(finder).found();
}

}  // namespace rt
