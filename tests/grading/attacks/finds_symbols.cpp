// attack: looks for the reference among the program's symbols
// ceiling: as a stub
#include "steps/step03_sphere/sphere.hpp"

#include <dlfcn.h>

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    if (dlsym(RTLD_DEFAULT, "_ZN2rt9intersectE") != nullptr) return 1;
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
