#include "common/explain/text.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace rt {

namespace {

std::string field(const char* name, const std::string& value) {
    return std::string(".") + name + " = " + value;
}

}  // namespace

std::string text(Real value) {
    if (std::isnan(value)) return "NaN";  // the sign of NaN has no meaning
    std::array<char, 64> buffer{};
    const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    return {buffer.data(), end};
}

std::string text(Vec2 v) {
    return "(" + text(v.x) + ", " + text(v.y) + ")";
}

std::string text(Vec3 v) {
    return "(" + text(v.x) + ", " + text(v.y) + ", " + text(v.z) + ")";
}

std::string code(Real value) {
    if (std::isnan(value)) return "NAN";  // of <cmath>, which every suite includes
    if (std::isinf(value)) return value > 0 ? "infinity" : "-infinity";
    const std::string digits = text(value);
    const bool whole = digits.find_first_of(".e") == std::string::npos;
    // An integer literal in C++ has no −0, and is limited: 2^31 is safe.
    const bool plain = whole && digits != "-0" && std::abs(value) <= Real(1U << 31);
    return plain ? digits : "Real(" + digits + (whole ? ".0)" : ")");
}

std::string code(Vec3 v) {
    return "{" + code(v.x) + ", " + code(v.y) + ", " + code(v.z) + "}";
}

std::string code(const Ray& ray) {
    return "Ray{" + field("origin", code(ray.origin)) + ", " +
           field("direction", code(ray.direction)) + "}";
}

std::string code(Interval interval) {
    return "Interval{" + field("min", code(interval.min)) + ", " +
           field("max", code(interval.max)) + "}";
}

std::string code(const Basis& basis) {
    return "Basis{" + field("x", code(basis.x)) + ", " + field("y", code(basis.y)) + ", " +
           field("z", code(basis.z)) + "}";
}

std::string code(const BoundingBox& box) {
    return "BoundingBox{" + field("min", code(box.min)) + ", " + field("max", code(box.max)) + "}";
}

std::string code(const Transform& transform) {
    return "Transform{" + field("rotation", code(transform.rotation)) + ", " +
           field("scale", code(transform.scale)) + ", " +
           field("translation", code(transform.translation)) + "}";
}

}  // namespace rt
