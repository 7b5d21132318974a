#include "docs/figures/source/sketch.hpp"

#include "steps/step02_camera_basis/camera_basis.hpp"

namespace rt::figures {

View looking_along(Vec3 direction, Vec2 place, Real scale) {
    const Basis basis = camera_basis(direction);
    return {.place = place, .scale = scale, .right = basis.x, .up = basis.y};
}

void Sketch::line(Vec3 from, Vec3 to, const Pen& pen) {
    svg_.line(view_(from), view_(to), pen);
}

void Sketch::arrow(Vec3 from, Vec3 to, const Pen& pen) {
    svg_.arrow(view_(from), view_(to), pen);
}

void Sketch::polygon(const std::vector<Vec3>& points, std::string_view fill, const Pen& pen) {
    std::vector<Vec2> placed;
    for (const Vec3& point : points) placed.push_back(view_(point));
    svg_.polygon(placed, fill, pen);
}

void Sketch::mark(Vec3 point, Mark what) {
    const Vec2 place = view_(point);
    switch (what) {
        case Mark::hit:
            return svg_.circle(place, 4.5, red, {.color = white, .width = 1});
        case Mark::refused:
            return svg_.circle(place, 4, white, {.color = red});
        case Mark::given:
            return svg_.circle(place, 3.5, ink, {.color = white, .width = 1});
        case Mark::foot:
            return svg_.circle(place, 3, gray, {.color = white, .width = 1});
    }
}

void Sketch::label(Vec3 point, Vec2 offset, std::string_view text, const TextStyle& style) {
    svg_.text(view_(point) + offset, text, style);
}

void Sketch::ray(const Ray& ray, Real end, const Pen& pen) {
    arrow(ray.origin, at(ray, end), pen);
}

void Sketch::normal(Vec3 point, Vec3 normal, Real length) {
    arrow(point, point + length / view_.scale * normal, {.color = green, .width = 1.8});
}

void Sketch::measure(Vec3 from, Vec3 to, Vec2 shift, const Pen& pen) {
    const Vec2 a = view_(from) + shift;
    const Vec2 b = view_(to) + shift;
    svg_.arrow((a + b) / Real(2), a, pen);
    svg_.arrow((a + b) / Real(2), b, pen);
}

void Sketch::angle(Vec3 corner, Vec3 from, Vec3 to, Real radius, const Pen& pen) {
    const Vec2 place = view_(corner);
    const Vec2 begin = normalize(view_(from) - place);
    const Vec2 end = normalize(view_(to) - place);
    std::vector<Vec2> arc;
    constexpr int steps = 24;
    for (int i = 0; i <= steps; ++i)
        arc.push_back(place + radius * normalize(mix(begin, end, Real(i) / steps)));
    svg_.polyline(arc, pen);
}

void Sketch::right_angle(Vec3 corner, Vec3 from, Vec3 to) {
    const Vec2 place = view_(corner);
    const Vec2 a = Real(10) * normalize(view_(from) - place);
    const Vec2 b = Real(10) * normalize(view_(to) - place);
    svg_.polyline({place + a, place + a + b, place + b}, thin);
}

}  // namespace rt::figures
