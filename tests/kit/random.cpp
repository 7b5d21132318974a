#include "tests/kit/random.hpp"

#include "common/math/vector.hpp"

#include <array>
#include <cmath>
#include <utility>

namespace rt {

double Random::choice() {
    if (!replays_) choices_.push_back(double(engine_() >> 11) * 0x1p-53);
    const double choice = next_ < choices_.size() ? choices_[next_] : 0.5;
    ++next_;
    return choice;
}

Real Random::between(Real low, Real high) {
    return low + Real(choice()) * (high - low);
}

Real Random::power_of_two() {
    return std::ldexp(Real(1), below(21) - 10);
}

Real Random::eighths(int low, int high) {
    return Real(low) + Real(below(8 * (high - low) + 1)) / 8;
}

bool Random::coin() {
    return choice() < 0.5;
}

int Random::below(int count) {
    return std::min(int(choice() * count), count - 1);
}

Vec3 Random::point(Real reach) {
    const Real x = between(-reach, reach);
    const Real y = between(-reach, reach);
    return {x, y, between(-reach, reach)};
}

Vec3 Random::point_in_eighths(int reach) {
    const Real x = eighths(-reach, reach);
    const Real y = eighths(-reach, reach);
    return {x, y, eighths(-reach, reach)};
}

Vec3 Random::direction() {
    const Vec3 v = point(1);  // denser towards a cube's corners, which does no harm
    return v == Vec3(0) ? Vec3(0, 0, 1) : unit(v);
}

Basis Random::basis() {
    const Vec3 z = direction();
    const Vec3 aside = std::abs(z.x) < std::abs(z.y) ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
    const Vec3 x = unit(cross(aside, z));
    const Vec3 y = cross(z, x);
    const Real angle = between(-pi, pi);
    const Real c = std::cos(angle);
    const Real s = std::sin(angle);
    return {.x = c * x + s * y, .y = c * y - s * x, .z = z};
}

Basis Random::axes() {
    std::array<Vec3, 3> all{Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
    std::swap(all[0], all[std::size_t(below(3))]);
    std::swap(all[1], all[std::size_t(1 + below(2))]);
    const Vec3 x = coin() ? all[0] : -all[0];
    const Vec3 y = coin() ? all[1] : -all[1];
    return {.x = x, .y = y, .z = cross(x, y)};
}

}  // namespace rt
