// attack: doubles templates, forty levels deep
// ceiling: as a stub
// compiles: no
#include "steps/step03_sphere/sphere.hpp"

template <int Depth, int Place>
struct Bomb {
    static constexpr long value =
        Bomb<Depth - 1, 2 * Place>::value + Bomb<Depth - 1, 2 * Place + 1>::value;
};
template <int Place>
struct Bomb<0, Place> {
    static constexpr long value = Place;
};
static_assert(Bomb<28, 0>::value != 1);

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
