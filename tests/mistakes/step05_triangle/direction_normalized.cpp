// origin: invented: t in the length of a direction made unit
// caught by: t counts in the length of the direction (PHY, any v)
// sentence: You normalize the direction: t counts in the length that the direction has.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step05_triangle/reference/triangle.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Triangle& triangle, Interval interval) {
    const auto t = correct_intersect(ray, triangle, interval);
    if (!t) return std::nullopt;
    return *t * length(ray.direction);
}

}  // namespace rt
