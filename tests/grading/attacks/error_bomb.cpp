// attack: makes the compiler print without end
// ceiling: as a stub
// compiles: no
#include "steps/step03_sphere/sphere.hpp"

template <int Depth>
struct Long : Long<Depth - 1>, Long<Depth - 2> {
    static_assert(Depth < 0, "an error for every depth");
};
template struct Long<800>;

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
