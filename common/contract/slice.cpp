#include "common/contract/difference_texts.hpp"

#include "common/geometry/ray.hpp"
#include "common/math/vector.hpp"
#include "common/scene/scene.hpp"
#include "common/system/text.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace rt::contract {

namespace {

constexpr double width = 480;
constexpr double height = 360;
constexpr int directions = 6;   ///< in which the plane is scanned
constexpr int scan_lines = 90;  ///< in each
constexpr int most_hits = 6;    ///< on one line

struct Size {
    Vec3 middle;
    Real reach;  ///< no part of the shape that matters is further from its middle
};

Vec3 part3(const Value& value, const char* name) {
    const Value* const found = find(value, name);
    return found == nullptr ? Vec3(0) : vec3(*found);
}

Size size_of(const Plane& plane, const Ray& ray) {
    const Vec3 n = unit(plane.normal);
    const Vec3 below = ray.origin - dot(ray.origin - plane.point, n) * n;
    return {below, std::max(Real(1), length(ray.origin - below))};
}

template <BoundedKindOfShape Shape>
Size size_of(const Shape& shape, const Ray& /*ray*/) {
    const auto& [center, radius] = bounding_sphere(shape);
    return {center, radius};
}

Size size_of(const Value& value, const Ray& ray) {
    Size size{.middle = Vec3(0), .reach = 2};  // of a mesh
    const auto look_for = [&]<class Shape>(const ShapeKind<Shape>& /*kind*/) {
        if (const auto shape = as<Shape>(value)) size = size_of(*shape, ray);
    };
    std::apply([&](const auto&... kind) { (look_for(kind), ...); }, shape_kinds);
    return size;
}

/// A direction of the shape's own, for a ray through its middle: that of its axis, or any.
Vec3 own_direction(const Value& shape, Vec3 along) {
    std::vector<Vec3> tried;
    for (const char* const name : {"axis", "normal"}) tried.push_back(part3(shape, name));
    if (const Value* const basis = find(shape, "basis"))
        for (const Value& axis : basis->parts) tried.push_back(vec3(axis));
    tried.insert(tried.end(),
                 {part3(shape, "b") - part3(shape, "a"), {0, 1, 0}, {1, 0, 0}, {0, 0, 1}});
    for (const Vec3& v : tried) {
        const Vec3 across = v - dot(v, along) * along;
        if (length(across) > Real(0.1) * length(v) && length(v) > 0) return across;
    }
    return {0, 1, 0};
}

/// The plane of the picture, whose scale is such that everything in it can be seen.
struct View {
    Vec3 center;
    Vec3 right;
    Vec3 up;
    double pixels_per_unit = 1;

    [[nodiscard]] double x(Vec3 p) const {
        return width / 2 + pixels_per_unit * double(dot(p - center, right));
    }
    [[nodiscard]] double y(Vec3 p) const {
        return height / 2 - pixels_per_unit * double(dot(p - center, up));
    }
};

class Drawing {
public:
    Drawing(const Difference& difference, Asked& reference)
        : call_(difference.call),
          reference_(reference),
          ray_{.origin = vec3(call_.arguments[0].parts[0]),
               .direction = vec3(call_.arguments[0].parts[1])},
          got_(t_of(difference.got)),
          expected_(t_of(difference.expected)),
          got_text_(hit_text(difference.got)),
          expected_text_(hit_text(difference.expected)) {
        const Value& shape = call_.arguments[1];
        const auto [middle, reach] = size_of(shape, ray_);
        view_.right = unit(ray_.direction);
        const Vec3 to_middle = middle - ray_.origin;
        Vec3 across = to_middle - dot(to_middle, view_.right) * view_.right;
        if (length(across) < Real(1e-6) * (reach + length(to_middle)))
            across = own_direction(shape, view_.right);
        view_.up = unit(across);
        frame(middle, reach);
    }

    /// Labels are lines of their own, which are translated where the drawing is shown.
    [[nodiscard]] std::string svg() {
        std::string text = formatted(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %.0f %.0f\" "
            "font-family=\"sans-serif\" font-size=\"13\">\n"
            "<rect width=\"100%%\" height=\"100%%\" fill=\"white\"/>\n",
            width, height);
        text += "<g fill=\"#5b7083\">\n" + section() + "</g>\n";
        const Vec3 end = ray_.origin + Real(2 * width / view_.pixels_per_unit) * view_.right;
        text += formatted(
            "<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke=\"#c08000\" "
            "stroke-width=\"1.5\"/>\n",
            view_.x(ray_.origin), view_.y(ray_.origin), view_.x(end), view_.y(end));
        text += mark(ray_.origin, "#c08000", "origin", -10);
        if (expected_) text += mark(at(ray_, *expected_), "#1a7f37", "expected", -10);
        if (got_) text += mark(at(ray_, *got_), "#cf222e", "yours", 22);
        text += formatted("<text x=\"10\" y=\"%.0f\" fill=\"#1a7f37\">\nexpected: %s\n</text>\n",
                          height - 28, expected_text_.c_str());
        text += formatted("<text x=\"10\" y=\"%.0f\" fill=\"#cf222e\">\nyours: %s\n</text>\n",
                          height - 10, got_text_.c_str());
        return text + "</svg>\n";
    }

private:
    static std::optional<Real> t_of(const Answer& answer) {
        if (!answer.value || answer.value->parts.empty()) return std::nullopt;
        const double t = answer.value->parts.front().number;
        if (!std::isfinite(t)) return std::nullopt;
        return Real(t);
    }

    static std::string hit_text(const Answer& answer) {
        if (!answer.value) return "no answer";
        if (answer.value->parts.empty()) return "no hit";
        return formatted("t = %.6g", answer.value->parts.front().number);
    }

    /// Around the shape, the ray's origin and the hits, with a margin.
    void frame(Vec3 middle, Real reach) {
        std::vector<Vec3> shown = {ray_.origin, middle - reach * view_.right,
                                   middle + reach * view_.right, middle - reach * view_.up,
                                   middle + reach * view_.up};
        for (const auto& t : {got_, expected_})
            if (t &&
                std::abs(*t) * length(ray_.direction) < 20 * (reach + length(middle - ray_.origin)))
                shown.push_back(at(ray_, *t));
        const auto range = [&shown](Vec3 axis) {
            const auto along = [axis](Vec3 p) { return dot(p, axis); };
            const auto [least, most] = std::ranges::minmax(shown, {}, along);
            return std::pair(along(least), along(most));
        };
        const auto [left, right] = range(view_.right);
        const auto [low, high] = range(view_.up);
        const Vec3 normal = cross(view_.right, view_.up);
        view_.center = (left + right) / 2 * view_.right + (low + high) / 2 * view_.up +
                       dot(ray_.origin, normal) * normal;
        view_.pixels_per_unit = std::min(0.8 * width / double(right - left),
                                         0.7 * height / double(std::max(high - low, Real(1e-9))));
    }

    /// The intersections of the shape with lines in the plane, in some directions.
    std::string section() {
        std::string dots;
        const double radius = std::hypot(width, height) / 2 / view_.pixels_per_unit;
        for (int direction = 0; direction < directions; ++direction) {
            const double angle = std::numbers::pi * (direction + 0.5) / directions;
            const Vec3 along =
                Real(std::cos(angle)) * view_.right + Real(std::sin(angle)) * view_.up;
            const Vec3 aside =
                Real(-std::sin(angle)) * view_.right + Real(std::cos(angle)) * view_.up;
            for (int i = 0; i < scan_lines; ++i) {
                const double offset = radius * (2 * (i + 0.5) / scan_lines - 1);
                dots += dots_along(
                    {.origin = view_.center + Real(offset) * aside - Real(radius) * along,
                     .direction = along},
                    2 * radius);
            }
        }
        return dots;
    }

    std::string dots_along(const Ray& line, double far) {
        Call call = call_;
        set_vec3(call.arguments[0].parts[0], line.origin);
        set_vec3(call.arguments[0].parts[1], line.direction);
        Value& interval = call.arguments[2];
        interval.parts[0].number = 0;
        interval.parts[1].number = far;
        std::string dots;
        for (int hit = 0; hit < most_hits; ++hit) {
            const auto t = t_of(reference_(call));
            if (!t) break;
            const Vec3 p = at(line, *t);
            dots +=
                formatted("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"1.2\"/>\n", view_.x(p), view_.y(p));
            interval.parts[0].number = double(*t) * (1 + 1e-9);
        }
        return dots;
    }

    [[nodiscard]] std::string mark(Vec3 p, const char* color, const char* word,
                                   double below) const {
        return formatted(
            "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"4\" fill=\"%s\"/>\n"
            "<text x=\"%.1f\" y=\"%.1f\" fill=\"%s\" text-anchor=\"middle\">\n%s\n</text>\n",
            view_.x(p), view_.y(p), color, view_.x(p), view_.y(p) + below, color, word);
    }

    Call call_;
    Asked& reference_;
    Ray ray_;
    std::optional<Real> got_;
    std::optional<Real> expected_;
    std::string got_text_;
    std::string expected_text_;
    View view_;
};

}  // namespace

bool can_be_drawn(const Call& call) {
    if (call.callee->answer != &type_of<std::optional<Real>>()) return false;
    bool finite = true;
    for (const Value& part : {call.arguments[0], call.arguments[1]})
        for_each_number(part, [&](const Value& v) { finite = finite && std::isfinite(v.number); });
    return finite;
}

std::string slice(const Difference& difference, Asked& reference) {
    return Drawing(difference, reference).svg();
}

}  // namespace rt::contract
