// attack: replaces operator new
// ceiling: as a stub
// compiles: no
// told: which all programs share
#include "steps/step03_sphere/sphere.hpp"

#include <cstdlib>
#include <new>

void* operator new(std::size_t) {
    return std::malloc(1 << 20);
}
void operator delete(void*) noexcept {}
void operator delete(void*, std::size_t) noexcept {}

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    return std::nullopt;
}

Vec3 normal(const Sphere&, Vec3) {
    return Vec3(0);
}

Color color_from_normal(Vec3) {
    return Color(0);
}

Real torch(Vec3, Vec3, Vec3) {
    return 0;
}

}  // namespace rt
