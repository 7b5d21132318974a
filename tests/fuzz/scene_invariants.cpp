#include "common/scene_file/reader.hpp"

#include "steps/step02_camera_basis/camera_basis.hpp"

#include "tests/fuzz/scene_invariants.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

namespace rt {

namespace {

void require(bool holds, const char* what) {
    if (holds) return;
    std::fprintf(stderr, "broken invariant: %s\n", what);
    std::abort();
}

/// unit() is good to 4 u and a basis to 10 u a component: this leaves room for a dot product.
constexpr Real tolerance = 64 * unit_roundoff;

bool near(Real value, Real expected) {
    return std::abs(value - expected) <= tolerance;  // fails on NaN
}

bool is_unit(Vec3 v) {
    return near(dot(v, v), 1);
}

bool within_one(Vec3 v) {
    return v.x >= 0 && v.x <= 1 && v.y >= 0 && v.y <= 1 && v.z >= 0 && v.z <= 1;
}

using Numbers = std::vector<Real>;

void add(Numbers& numbers, Vec3 v) {
    numbers.insert(numbers.end(), {v.x, v.y, v.z});
}

/// Right-handed or left-handed.
void add_axes(Numbers& numbers, const Basis& basis) {
    const auto& [x, y, z] = basis;
    require(is_unit(x) && is_unit(y) && is_unit(z), "axes have unit length");
    require(near(dot(x, y), 0) && near(dot(y, z), 0) && near(dot(z, x), 0),
            "axes are at right angles");
    for (const Vec3& v : {x, y, z}) add(numbers, v);
}

void add(Numbers& numbers, const Basis& basis) {
    require(near(dot(cross(basis.x, basis.y), basis.z), 1), "a basis is right-handed");
    add_axes(numbers, basis);
}

// The fields of a shape, whose name says whether a vector is a direction, a size or a place.
void add_field(Numbers& numbers, std::string_view name, Vec3 v) {
    if (name == "axis" || name == "normal") require(is_unit(v), "an axis has unit length");
    if (name == "half_size") require(v.x > 0 && v.y > 0 && v.z > 0, "a box has a size");
    add(numbers, v);
}
void add_field(Numbers& numbers, std::string_view /*name*/, const Basis& basis) {
    add(numbers, basis);
}
void add_field(Numbers& numbers, std::string_view /*name*/, Real size) {
    require(size > 0, "a size is positive");
    numbers.push_back(size);
}
void add_field(Numbers& numbers, std::string_view /*name*/, bool flag) {
    numbers.push_back(Real(flag));
}

template <KindOfShape Shape>
void add(Numbers& numbers, const Shape& shape) {
    std::apply(
        [&](const auto&... field) { (add_field(numbers, field.name, shape.*field.member), ...); },
        shape_record<Shape>.fields);
}

void add(Numbers& numbers, const Material& material) {
    const auto& [color, specular, shininess, mirror] = material;
    require(within_one(color), "a color is from 0 to 1");
    require(within_one({specular, mirror, 0}), "shares are from 0 to 1");
    require(shininess > 0, "a shininess is positive");
    add(numbers, color);
    numbers.insert(numbers.end(), {specular, shininess, mirror});
}

void add(Numbers& numbers, const MeshRequest& mesh) {
    require(!mesh.file.empty() && mesh.place.line > 0, "a mesh has a file, and its place");
    require(mesh.placement.scale > 0, "a mesh's scale is positive");
    add_axes(numbers, mesh.placement.rotation);  // left-handed in a left-handed scene
    add(numbers, mesh.placement.translation);
    add(numbers, mesh.material);
    numbers.insert(numbers.end(), {mesh.placement.scale, Real(mesh.smooth)});
}

template <class Shape>
void add(Numbers& numbers, const PrimitiveList<Shape>& primitives) {
    numbers.push_back(Real(primitives.size()));
    for (const Primitive<Shape>& primitive : primitives) {
        add(numbers, primitive.shape);
        add(numbers, primitive.material);
    }
}

void add(Numbers& numbers, const Camera& camera) {
    require(is_unit(camera.direction), "a camera's direction has unit length");
    require(camera.fov >= 0 && std::tan(camera.fov / 2) >= 0, "a field of view is from 0 to pi");
    add(numbers, camera.position);
    add(numbers, camera.direction);
    numbers.insert(numbers.end(), {camera.fov, Real(camera.fov_axis == FovAxis::vertical)});
}

/// A light's or the ambient light's numbers but its position.
void add_light(Numbers& numbers, Real ratio, Color color) {
    require(ratio >= 0 && ratio <= 1, "a ratio is from 0 to 1");
    require(within_one(color), "a light's color is from 0 to 1");
    numbers.push_back(ratio);
    add(numbers, color);
}

/// Every number of the scene, each of them checked.
Numbers checked_numbers(const Scene& scene) {
    const auto [width, height] = scene.resolution;
    require(0 < width && width <= 8192 && 0 < height && height <= 8192, "a picture has a size");
    require(!scene.cameras.empty(), "there is a camera");
    Numbers numbers = {Real(width), Real(height), Real(scene.cameras.size())};
    for (const Camera& camera : scene.cameras) add(numbers, camera);
    numbers.push_back(Real(scene.ambient.has_value()));
    if (scene.ambient) add_light(numbers, scene.ambient->ratio, scene.ambient->color);
    numbers.push_back(Real(scene.lights.size()));
    for (const Light& light : scene.lights) {
        add(numbers, light.position);
        add_light(numbers, light.brightness, light.color);
        require(light.radius >= 0, "a light's radius is not negative");
        numbers.push_back(light.radius);
    }
    numbers.push_back(Real(scene.sky.has_value()));
    if (scene.sky) {
        const auto& [bottom, top] = *scene.sky;
        require(within_one(bottom) && within_one(top), "a sky's colors are from 0 to 1");
        add(numbers, bottom);
        add(numbers, top);
    }
    for_each_kind(scene, [&numbers](const auto& primitives) { add(numbers, primitives); });
    require(scene.meshes.empty(), "reading loads no mesh");
    numbers.push_back(Real(scene.mesh_requests.size()));
    for (const MeshRequest& mesh : scene.mesh_requests) add(numbers, mesh);
    const auto finite = [](Real number) { return std::isfinite(number); };
    require(std::all_of(numbers.begin(), numbers.end(), finite), "numbers are finite");
    return numbers;
}

void check_message(const std::string& message, const char* kind) {
    const auto printable = [](char c) { return ' ' <= c && c <= '~'; };
    require(message.starts_with("fuzz.rt:"), "a message begins with the file");
    require(message.find(kind) != std::string::npos, "a message says what it is");
    require(std::all_of(message.begin(), message.end(), printable), "a message is printable");
    require(message.size() < 400, "a message is short");
}

/// The numbers of the scene, nothing if it is refused.
std::optional<Numbers> read(std::string_view text, bool strict) {
    int warnings = 0;
    const auto warn = [&warnings](const std::string& message) {
        check_message(message, "warning: ");
        require(++warnings <= 21, "the warnings end");
    };
    try {
        return checked_numbers(
            parse_scene(text, "fuzz.rt", orthonormal_basis, {.strict = strict, .warn = warn}));
    } catch (const InputError& error) {
        check_message(error.what(), "error: ");
        return std::nullopt;
    }
}

}  // namespace

void RT_PRECISION::check_invariants(std::string_view text) {
    const auto strict = read(text, true);
    const auto lenient = read(text, false);
    require(!strict || lenient, "lenient reading accepts what strict reading accepts");
    require(!strict || *strict == *lenient, "both read the same scene");
}

}  // namespace rt
