// right: a direction in the cone, and stage 3's intersection with the sphere
#define sample_light(...) correct_light_point(__VA_ARGS__)
#include "steps/step11_soft_shadows/reference/soft_shadows.cpp"
#undef sample_light

#include "steps/step03_sphere/sphere.hpp"

namespace rt {

Vec3 sample_light(const Light& light, Vec3 from, Vec2 sample) {
    const Vec3 way = light.position - from;
    const Real distance = length(way);
    if (light.radius == 0 || distance <= light.radius) return light.position;
    const Real sine_max = light.radius / distance;
    const Real cosine_max = std::sqrt(1 - sine_max * sine_max);
    const Real drop = sample.x * sine_max * sine_max / (1 + cosine_max);  // 1 − cos θ
    const Real sine = std::sqrt(drop * (2 - drop));
    const Real turn = 2 * pi * sample.y;
    const Vec3 z = way / distance;
    const Vec3 aside = std::abs(z.y) < Real(0.9) ? Vec3(0, 1, 0) : Vec3(1, 0, 0);
    const Vec3 x = unit(cross(aside, z));
    const Vec3 y = cross(z, x);
    const Ray ray{.origin = from,
                  .direction = sine * (std::cos(turn) * x + std::sin(turn) * y) + (1 - drop) * z};
    const std::optional<Real> t =
        intersect(ray, Sphere{.center = light.position, .radius = light.radius}, Interval{});
    return at(ray, t ? *t : distance * cosine_max);  // rounding: at the rim
}

}  // namespace rt
