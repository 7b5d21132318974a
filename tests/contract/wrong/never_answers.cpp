// A loop without end.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step03_sphere/reference/sphere.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Sphere& sphere, Interval interval) {
    volatile bool searching = true;
    while (searching) continue;
    return correct_intersect(ray, sphere, interval);
}

}  // namespace rt
