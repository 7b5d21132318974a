#include "common/contract/open_answers.hpp"

#include "common/contract/contracts.hpp"
#include "common/math/vector.hpp"

#include <algorithm>
#include <cmath>

namespace rt::contract {

namespace {

/// A number of an answer, and the least difference that counts.
struct Measure {
    double value;
    double floor;
};

constexpr double relative_difference = 0.1;

template <class T>
T typed(const Value& value) {
    Writer writer;
    put_value(writer, value);
    Reader reader(writer.bytes());
    return get<T>(reader);
}

/// The origin of a ray: the height above the surface and the distance aside, in errors of the
/// point. A right start is less than ten errors above.
std::vector<Measure> start_of(const ShadingPoint& surface, Vec3 start) {
    constexpr double floor = 0.3;
    const Vec3 offset = start - surface.point;
    const double height = dot(offset, surface.geometric_normal) / surface.error;
    const double length_squared = dot(offset, offset) / (surface.error * surface.error);
    const double aside = std::sqrt(std::max(length_squared - height * height, 0.0));
    const bool right = height > 1 - floor && height < 10 && aside < floor;
    return {{right ? 1 : height, floor}, {right ? 0 : aside, floor}};
}

/// The length of the interval behind the light, relative to the light's distance. A right end is
/// a little before it.
Measure end_of(const ShadingPoint& surface, Vec3 light, const ShadowRay& way) {
    constexpr double little = 0.002;
    constexpr double right = -1;  // as no other
    const Vec3 there = light - surface.point;
    const double distance = std::max(length(there), length(light - at(way.ray, way.interval.min)));
    const double rounding = 16 * unit_roundoff * (1 + length(light) / distance);
    if (std::isinf(way.interval.max)) return {double(way.interval.max), rounding};
    const double behind = dot(at(way.ray, way.interval.max) - light, unit(there)) / distance;
    if (behind > -little && behind < -rounding) return {right, rounding};
    return {behind, rounding};
}

std::vector<Measure> measures(const ShadingPoint& surface, Vec3 light, const ShadowRay& way) {
    std::vector<Measure> all = start_of(surface, at(way.ray, way.interval.min));
    all.push_back(end_of(surface, light, way));
    return all;
}

/// The direction, in lengths of the ray's.
std::vector<Measure> measures(const Ray& ray, const ShadingPoint& surface, const Ray& reflected) {
    constexpr double floor = 0.02;
    std::vector<Measure> all = start_of(surface, reflected.origin);
    for (glm::length_t i = 0; i < 3; ++i)
        all.push_back({reflected.direction[i] / length(ray.direction), floor});
    return all;
}

/// The point's distance from the light's center, and the part of it towards the surface.
std::vector<Measure> measures(const Light& light, Vec3 from, Vec3 point) {
    constexpr double floor = 0.02;
    const Vec3 away = from - light.position;
    const Vec3 on_light = point - light.position;
    const double size = light.radius > 0 ? double(light.radius) : 1;
    const double axis = length(away);
    return {{length(on_light) / size, floor},
            {axis > 0 ? dot(on_light, away) / axis / size : 0, floor}};
}

std::vector<Measure> measures(const Call& call, const Value& answer) {
    const std::vector<Value>& arguments = call.arguments;
    if (call.callee->name == "shadow_ray")
        return measures(typed<ShadingPoint>(arguments[0]), typed<Vec3>(arguments[1]),
                        typed<ShadowRay>(answer));
    if (call.callee->name == "mirrored")
        return measures(typed<Ray>(arguments[0]), typed<ShadingPoint>(arguments[1]),
                        typed<Ray>(answer));
    if (call.callee->name == "sample_light")
        return measures(typed<Light>(arguments[0]), typed<Vec3>(arguments[1]), typed<Vec3>(answer));
    return {};
}

bool close_measures(const Measure& a, const Measure& b) {
    if (std::isnan(a.value) || std::isnan(b.value))
        return std::isnan(a.value) && std::isnan(b.value);
    if (std::isinf(a.value) || std::isinf(b.value)) return a.value == b.value;
    const double size = std::max(std::abs(a.value), std::abs(b.value));
    return std::abs(a.value - b.value) <= std::max(relative_difference * size, a.floor);
}

}  // namespace

bool same_kind(const Call& call, const Answer& got, const Answer& expected) {
    if (!got.value || !expected.value) return same(got, expected, 0);
    const std::vector<Measure> all = measures(call, *got.value);
    return std::ranges::equal(all, measures(call, *expected.value), close_measures);
}

bool is_compared_by_kind(const Callee& callee) {
    return callee.name == "shadow_ray" || callee.name == "mirrored" ||
           callee.name == "sample_light";
}

}  // namespace rt::contract
