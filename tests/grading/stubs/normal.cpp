#include "steps/step03_sphere/sphere.hpp"

namespace rt {

Vec3 normal(const Sphere&, Vec3) {
    return Vec3(0);
}

}  // namespace rt
