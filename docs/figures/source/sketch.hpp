// Space on a page: a slice of it, or a parallel projection.
#pragma once

#include "docs/figures/source/svg.hpp"

#include "common/geometry/ray.hpp"

#include <optional>

namespace rt::figures {

/// A projection of points in space onto the page. Depth is dropped.
struct View {
    Vec2 place;           ///< the position of `center` on the page
    Real scale = 100;     ///< pixels a unit
    Vec3 right{1, 0, 0};  ///< the page's own directions, unit length
    Vec3 up{0, 1, 0};
    Vec3 center{0};

    [[nodiscard]] Vec2 operator()(Vec3 point) const {
        const Vec3 p = point - center;
        return place + scale * Vec2(dot(p, right), -dot(p, up));
    }
};

/// The view along a direction, with stage 2's up direction.
[[nodiscard]] View looking_along(Vec3 direction, Vec2 place, Real scale);

/// The meaning of a point.
enum class Mark {
    hit,      ///< the smallest t strictly inside the interval
    refused,  ///< a solution that is not it
    given,    ///< an origin, a center, a vertex
    foot,     ///< construction
};

/// Draws objects in space on a page.
class Sketch {
public:
    Sketch(Svg& svg, const View& view) : svg_(svg), view_(view) {}

    void line(Vec3 from, Vec3 to, const Pen& pen = {});
    void arrow(Vec3 from, Vec3 to, const Pen& pen = {});
    void polygon(const std::vector<Vec3>& points, std::string_view fill, const Pen& pen = {});
    void mark(Vec3 point, Mark what);
    /// The label's base line starts, is centered or ends at this offset from the point, in pixels.
    void label(Vec3 point, Vec2 offset, std::string_view text, const TextStyle& style = {});

    /// The part of the ray from t = 0 on, with an arrow head at the end.
    void ray(const Ray& ray, Real end, const Pen& pen = {.color = blue, .width = 1.8});
    /// A unit normal, `length` pixels long.
    void normal(Vec3 point, Vec3 normal, Real length = 40);

    /// A line with two heads beside the line from one point to the other, `shift` pixels away.
    void measure(Vec3 from, Vec3 to, Vec2 shift, const Pen& pen = thin);
    /// The angle at the corner between the lines to the two points.
    void angle(Vec3 corner, Vec3 from, Vec3 to, Real radius, const Pen& pen = thin);
    void right_angle(Vec3 corner, Vec3 from, Vec3 to);

    [[nodiscard]] Vec2 operator()(Vec3 point) const { return view_(point); }

private:
    Svg& svg_;
    View view_;
};

/// Every t, of either sign, of an intersection of the line with the shape: `intersect`, called
/// again after each answer.
template <class Shape>
[[nodiscard]] std::vector<Real> all_roots(const Ray& ray, const Shape& shape) {
    std::vector<Real> roots;
    Interval rest{.min = -infinity};
    while (const std::optional<Real> t = intersect(ray, shape, rest)) {
        roots.push_back(*t);
        rest.min = *t;
    }
    return roots;
}

/// The point that the ray hits first. The shape must be there.
template <class Shape>
[[nodiscard]] Vec3 first_hit(const Ray& ray, const Shape& shape) {
    return at(ray, intersect(ray, shape, {}).value());
}

}  // namespace rt::figures
