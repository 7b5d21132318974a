// Ignores the height of the ray's origin, which is not a known mistake.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step03_sphere/reference/sphere.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Sphere& sphere, Interval interval) {
    const Vec3 origin(ray.origin.x, 0, ray.origin.z);
    return correct_intersect(Ray{.origin = origin, .direction = ray.direction}, sphere, interval);
}

}  // namespace rt
