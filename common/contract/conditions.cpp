#include "common/contract/conditions.hpp"

#include "common/contract/call_parts.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace rt::contract {

namespace {

bool is_unit(Vec3 v) {
    return std::abs(dot(v, v) - 1) < 1e-9;
}

bool orthonormal(const Value& basis) {
    const Vec3 x = vec3(basis.parts[0]);
    const Vec3 y = vec3(basis.parts[1]);
    const Vec3 z = vec3(basis.parts[2]);
    const Vec3 off = cross(x, y) - z;
    return is_unit(x) && is_unit(y) && dot(off, off) < 1e-18;
}

bool is_coordinate(const std::string& name) {
    constexpr std::array lengths = {"radius", "height", "side",       "scale",    "error",
                                    "ratio",  "mirror", "brightness", "specular", "shininess"};
    return !name.empty() && std::ranges::find(lengths, name) == lengths.end();
}

bool keeps(const Value& value, const Value& before, const std::string& name) {
    if (value.type != before.type) return true;  // something was left out before it
    if (is_basis(value)) return !orthonormal(before) || orthonormal(value);
    if (value.type == &type_of<Interval>()) {
        const auto [min, max] = std::pair(value.parts[0].number, value.parts[1].number);
        return min >= 0 && min < max;
    }
    if (value.type == &type_of<BoundingBox>()) {
        const Vec3 size = vec3(value.parts[1]) - vec3(value.parts[0]);
        return size.x > 0 && size.y > 0 && size.z > 0;
    }
    if (is_vec3(value)) {
        if (is_place(name)) return true;
        const Vec3 v = vec3(value);
        const bool was_unit = is_unit(vec3(before)) && name != "direction";
        return was_unit ? is_unit(v) : dot(v, v) > 0 || dot(vec3(before), vec3(before)) == 0;
    }
    if (value.type->kind == Type::Kind::integer) return value.number >= 0;
    // A single number: a length, an angle, a share.
    const bool alone = value.type->kind == Type::Kind::real;
    if (!alone || is_coordinate(name)) return true;
    if (before.number > 0 && !(value.number > 0)) return false;
    return !(before.number >= 0 && before.number <= 1) || (value.number >= 0 && value.number <= 1);
}

/// A pixel is one of its picture's.
bool in_picture(const Call& call) {
    const Value* pixel = nullptr;
    const Value* picture = nullptr;
    for (const Value& argument : call.arguments) {
        if (argument.type == &type_of<Pixel>()) pixel = &argument;
        if (argument.type == &type_of<Resolution>()) picture = &argument;
    }
    if (picture == nullptr || pixel == nullptr) return true;
    return pixel->parts[0].number < picture->parts[1].number &&
           pixel->parts[1].number < picture->parts[0].number;
}

}  // namespace

bool Conditions::hold(Call call) const {
    bool all = true;
    Call start = start_;
    std::vector<std::pair<Value*, std::string>> before;
    for_each_within(start, [&](Value& v, const std::string& name) {
        before.push_back({&v, name});
    });
    std::size_t i = 0;
    for_each_within(call, [&](Value& value, const std::string& name) {
        if (i < before.size()) all = all && keeps(value, *before[i].first, name);
        ++i;
    });
    return all && (i == before.size() || !start_.arguments.empty()) && in_picture(call);
}

bool is_free(const Callee& callee) {
    constexpr std::array bound = {"normal",     "barycentric",         "square_uv",
                                  "reflected",  "interpolated_normal", "mirrored",
                                  "shadow_ray", "unprojected_ray"};
    return std::ranges::find(bound, callee.name) == bound.end();
}

}  // namespace rt::contract
