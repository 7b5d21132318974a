// Enlarges the sphere, which is not a known mistake.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step03_sphere/reference/sphere.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Sphere& sphere, Interval interval) {
    return correct_intersect(
        ray, Sphere{.center = sphere.center, .radius = sphere.radius * Real(1.1)}, interval);
}

}  // namespace rt
