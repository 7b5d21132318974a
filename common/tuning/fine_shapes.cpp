#include "common/tuning/render_trials.hpp"

#include "common/geometry/outlines.hpp"
#include "common/render/sampling.hpp"
#include "common/render/stage.hpp"
#include "common/scene/surface_points.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

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
                    std::vector<float>(std::size_t(size_.width) * std::size_t(size_.height), 1)},
          outlines_(size_.width, size_.height) {}

    template <class Shape>
    void take(const Shape& shape, Real width, const char* name) {
        const BoundingSphere ball = bounding_sphere(shape);
        const Place center = place(ball.center);
        const auto radius = double(ball.radius);
        const double nearest = pixels_in_unit_ / center.scale - radius;
        if (center.scale < 0 && radius < -pixels_in_unit_ / center.scale) return;
        const double farthest = nearest + 2 * radius;
        double seen = 1;  // its width in the picture, if that is less because it is seen from aside
        if (nearest <= 0 || double(width) * pixels_in_unit_ / nearest >= 1)
            seen =
                add_outline(shape, radius * pixels_in_unit_ / std::max(nearest, radius / 4), name);
        if (seen >= 1 && double(width) * pixels_in_unit_ / farthest >= 1) return;
        const auto mark_at = [&](const Place& point, double reach) {
            mark(point, std::min(double(width) * point.scale, seen), 2 * radius * point.scale,
                 reach, name);
        };
        const bool is_dot = nearest > 0 && radius * center.scale < 0.5;
        if (is_dot) return mark_at(center, radius * center.scale);
        const double most = 4.0 * (size_.width + size_.height);
        const double length = nearest > 0 ? 2 * radius * pixels_in_unit_ / nearest : most;
        const auto points = std::uint32_t(std::ceil(4 * std::min(length, most)));
        for (std::uint32_t i = 0; i < points; ++i)
            mark_at(place(surface_point(shape, spread_sample(i, 0))), 0.25);
    }

    [[nodiscard]] FineShapes found() && {
        mark_gaps();
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

    /// Adds the outline of a shape whose radius has so many pixels, and returns its width. A circle
    /// has so many corners that they are off by a hundredth of a pixel.
    template <class Shape>
    double add_outline(const Shape& shape, double radius, const char* name) {
        constexpr double most = 1000;
        constexpr std::size_t few = 8;
        const int count = int(std::min(8 + 22 * std::sqrt(radius), most));
        const std::vector<Vec3> points = outline(shape, view_.position, count);
        std::vector<PicturePoint> seen;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Place point = place(points[i]);
            if (point.scale > 0) seen.emplace_back(point.x, point.y);
            // A line to a point behind the camera is cut in front of it.
            for (std::size_t k = 0; k < points.size() && point.scale < 0; ++k) {
                if (points.size() > few && k != (i ^ 1)) continue;
                const Place before = place(points[k]);
                if (!(before.scale > 0)) continue;
                const double part = before.scale / (before.scale - point.scale);
                const Place end = place(glm::mix(points[k], points[i], Real(0.999 * (1 - part))));
                if (end.scale > 0) seen.emplace_back(end.x, end.y);
            }
        }
        return outlines_.add(std::move(seen), name);
    }

    /// Marks the pixels of gaps between shapes. Where two outlines cross, the widest part of the
    /// gap counts.
    void mark_gaps() {
        std::map<std::pair<int, int>, Gap> widest;
        for (const Gap& gap : outlines_.gaps())
            visit_pixels(gap.middle.x, gap.middle.y, gap.width < 1 ? 0.25 : 0,
                         [&](int row, int column) {
                             Gap& known = widest[{row, column}];
                             if (gap.width > known.width) known = gap;
                         });
        for (const auto& [pixel, gap] : widest)
            if (gap.width < 1)
                mark(pixel.first, pixel.second, gap.width, gap.length,
                     std::string("gap beside a ") + gap.kind);
    }

    /// Marks the pixels within `reach` pixels of a point of a shape.
    void mark(const Place& point, double width, double length, double reach, const char* name) {
        if (!(0 <= width && width < 1)) return;
        visit_pixels(point.x, point.y, reach,
                     [&](int row, int column) { mark(row, column, width, length, name); });
    }

    /// Marks a pixel for a detail of this width and length in it.
    void mark(int row, int column, double width, double length, const std::string& name) {
        float& least =
            fine_.parts[std::size_t(row) * std::size_t(size_.width) + std::size_t(column)];
        least = std::min(least, float(width * std::min(length, 1.0) / 2));
        if (!fine_.narrowest.empty() && width >= fine_.width) return;
        fine_.width = width;
        fine_.narrowest = name;
    }

    /// Visits the pixels within `reach` pixels of a point.
    template <class Visit>
    void visit_pixels(double x, double y, double reach, const Visit& visit) const {
        const auto clipped = [](double value, int size) {
            return int(std::clamp(std::floor(value), 0.0, double(size)));
        };
        const int last_column = clipped(x + reach + 1, size_.width);
        const int last_row = clipped(y + reach + 1, size_.height);
        for (int row = clipped(y - reach, size_.height); row < last_row; ++row)
            for (int column = clipped(x - reach, size_.width); column < last_column; ++column)
                visit(row, column);
    }

    Resolution size_;
    PixelRays view_;
    double pixels_in_unit_;
    FineShapes fine_;
    Outlines outlines_;
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
