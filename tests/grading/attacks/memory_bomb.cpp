// attack: takes all memory there is
// ceiling: as a stub
#include "steps/step03_sphere/sphere.hpp"

#include <cstdlib>
#include <cstring>

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    for (;;) {
        void* piece = std::malloc(1 << 24);
        if (piece != nullptr) std::memset(piece, 1, 1 << 24);
    }
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
