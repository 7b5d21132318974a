// The fields of all values in a contract, listed once: their bytes, their text, and their
// comparison follow from it.
#pragma once

#include "common/geometry/mesh.hpp"
#include "common/geometry/shape.hpp"
#include "common/geometry/transform.hpp"
#include "common/image/image.hpp"
#include "common/render/context.hpp"
#include "common/render/surface.hpp"
#include "common/scene/scene.hpp"
#include "steps/step10_shadows/shadows.hpp"
#include "steps/step11_soft_shadows/soft_shadows.hpp"

#include <optional>
#include <tuple>
#include <type_traits>
#include <vector>

namespace rt::contract {

/// The fields of T, in their order: of a shape, those of its kind.
template <class T>
inline constexpr auto record = shape_record<T>;

template <>
inline constexpr auto record<Pixel> = record_of("Pixel", field("row", &Pixel::row),
                                                field("column", &Pixel::column));
template <>
inline constexpr auto record<Resolution> = record_of("Resolution",
                                                     field("width", &Resolution::width),
                                                     field("height", &Resolution::height));
template <>
inline constexpr auto record<Ray> = record_of("Ray", field("origin", &Ray::origin),
                                              field("direction", &Ray::direction));
template <>
inline constexpr auto record<Interval> = record_of("Interval", field("min", &Interval::min),
                                                   field("max", &Interval::max));
template <>
inline constexpr auto record<Basis> = record_of("Basis", field("x", &Basis::x),
                                                field("y", &Basis::y), field("z", &Basis::z));
template <>
inline constexpr auto record<BoundingBox> = record_of("BoundingBox",
                                                      field("min", &BoundingBox::min),
                                                      field("max", &BoundingBox::max));
template <>
inline constexpr auto record<Transform> = record_of("Transform",
                                                    field("rotation", &Transform::rotation),
                                                    field("scale", &Transform::scale),
                                                    field("translation", &Transform::translation));
template <>
inline constexpr auto record<Mesh> = record_of("Mesh", field("vertices", &Mesh::vertices),
                                               field("normals", &Mesh::normals),
                                               field("triangles", &Mesh::triangles));
template <>
inline constexpr auto record<MeshHit> = record_of("MeshHit", field("t", &MeshHit::t),
                                                  field("triangle", &MeshHit::triangle),
                                                  field("weights", &MeshHit::weights));
template <>
inline constexpr auto record<Material> = record_of("Material", field("color", &Material::color),
                                                   field("specular", &Material::specular),
                                                   field("shininess", &Material::shininess),
                                                   field("mirror", &Material::mirror));
template <>
inline constexpr auto record<ShadingPoint> = record_of(
    "ShadingPoint", field("point", &ShadingPoint::point), field("normal", &ShadingPoint::normal),
    field("geometric_normal", &ShadingPoint::geometric_normal),
    field("to_eye", &ShadingPoint::to_eye), field("error", &ShadingPoint::error),
    field("material", &ShadingPoint::material));
template <>
inline constexpr auto record<Ambient> = record_of("Ambient", field("ratio", &Ambient::ratio),
                                                  field("color", &Ambient::color));
template <>
inline constexpr auto record<Light> = record_of("Light", field("position", &Light::position),
                                                field("brightness", &Light::brightness),
                                                field("color", &Light::color),
                                                field("radius", &Light::radius));
template <>
inline constexpr auto record<Sky> = record_of("Sky", field("bottom", &Sky::bottom),
                                              field("top", &Sky::top));
template <>
inline constexpr auto record<ShadowRay> = record_of("ShadowRay", field("ray", &ShadowRay::ray),
                                                    field("interval", &ShadowRay::interval));
template <>
inline constexpr auto record<ShadowRays> = record_of("ShadowRays", field("sent", &ShadowRays::sent),
                                                     field("reached", &ShadowRays::reached));

// The additional fields of a picture.
template <>
inline constexpr auto record<Camera> = record_of("Camera", field("position", &Camera::position),
                                                 field("direction", &Camera::direction),
                                                 field("fov", &Camera::fov),
                                                 field("fov_axis", &Camera::fov_axis));
template <>
inline constexpr auto record<RenderSettings> = record_of(
    "RenderSettings", field("shading", &RenderSettings::shading),
    field("term", &RenderSettings::term), field("gamma", &RenderSettings::gamma),
    field("pixel_samples", &RenderSettings::pixel_samples),
    field("pixel_error", &RenderSettings::pixel_error),
    field("shadow_samples", &RenderSettings::shadow_samples),
    field("shadow_error", &RenderSettings::shadow_error),
    field("shadow_agree", &RenderSettings::shadow_agree), field("depth", &RenderSettings::depth));

template <class T>
inline constexpr bool is_number = std::is_arithmetic_v<T> || std::is_enum_v<T>;

template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;

/// A list of any length.
template <class T>
inline constexpr bool is_sequence = false;
template <class T>
inline constexpr bool is_sequence<std::vector<T>> = true;

/// The number of equal parts of a value: the coordinates of a Vec3.
template <class T>
inline constexpr int part_count = 0;
template <glm::length_t Count, class T>
inline constexpr int part_count<glm::vec<Count, T>> = Count;
template <glm::length_t Columns, glm::length_t Rows, class T>
inline constexpr int part_count<glm::mat<Columns, Rows, T>> = Columns;
template <class T, std::size_t Count>
inline constexpr int part_count<std::array<T, Count>> = int(Count);

template <class T>
inline constexpr bool is_record = !std::is_null_pointer_v<std::remove_cv_t<decltype(record<T>)>>;

/// Calls visit(part) for the parts of a value that has parts, in their order.
template <class T, class Visit>
void for_each_part(T& value, Visit visit) {
    using Plain = std::remove_const_t<T>;
    if constexpr (is_record<Plain>) {
        std::apply([&](const auto&... fields) { (visit(value.*fields.member), ...); },
                   record<Plain>.fields);
    } else {
        static_assert(part_count<Plain> > 0, "fields.hpp does not know this type");
        for (int i = 0; i < part_count<Plain>; ++i) visit(value[i]);
    }
}

}  // namespace rt::contract
