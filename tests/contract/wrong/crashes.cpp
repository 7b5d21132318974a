// Crashes for rays with a positive x direction.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step03_sphere/reference/sphere.cpp"
#undef intersect

#include <cstdlib>

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Sphere& sphere, Interval interval) {
    if (ray.direction.x > Real(0.25)) std::abort();
    return correct_intersect(ray, sphere, interval);
}

}  // namespace rt
