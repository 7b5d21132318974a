// Functions of the figures of the book beside the contracts of the stages: the explanations of
// `--pixel`, and the documents' own ways where a page compares them with the stage's.
#pragma once

#include "common/contract/contracts.hpp"

#include <optional>
#include <vector>

namespace rt::book {

/// The text of an explanation, line by line as `--pixel` writes it.
using Text = std::vector<char>;

/// The explanation of one candidate: what decides whether the ray hits the shape.
template <class Shape>
[[nodiscard]] Text explain_shape(const Ray& ray, const Shape& shape, Interval interval);

[[nodiscard]] Text explain_screen(Pixel pixel, Resolution resolution, Real vertical_fov);
[[nodiscard]] Text explain_light(const ShadingPoint& surface, const Light& light);

/// M1's (I P V)⁻¹ of OpenGL's camera at the origin, which faces −z.
[[nodiscard]] Mat4 image_to_world(Resolution resolution, Real vertical_fov, Real near, Real far);

/// MRT §2 as printed: X is (0, 1, 0) ∧ Z, whatever its length.
[[nodiscard]] Basis printed_basis(Vec3 direction);

/// A plane whose test refuses rays with |⟨d, n⟩| < epsilon, as many programs have it.
[[nodiscard]] std::optional<Real> intersect_with_epsilon(const Ray& ray, const Plane& plane,
                                                         Interval interval, Real epsilon);

/// The shading point of the closest hit, or nothing.
template <class Shape>
[[nodiscard]] std::optional<ShadingPoint> shade(const Ray& ray, const Shape& shape);

/// CR §3.2 as printed: the ray starts at the point itself, and hits before t = epsilon do not
/// count, where the light is at t = 1 / distance.
[[nodiscard]] ShadowRay printed_shadow_ray(const ShadingPoint& surface, Vec3 light, Real epsilon);

/// Stage 11's well-spread samples, and independent ones.
[[nodiscard]] Vec2 well_spread_sample(std::uint32_t index, std::uint32_t seed);
[[nodiscard]] Vec2 independent_sample(std::uint32_t index, std::uint32_t seed);

/// A ball of radius 1 around the origin, seen along −to_eye from far away: side × side pixels in
/// blue, green, red and opacity. `to_eye` is in the plane z = 0, which is upright in the picture.
[[nodiscard]] std::vector<std::uint8_t> lit_ball(const Light& light, const Ambient& ambient,
                                                 const Material& material, Vec3 to_eye,
                                                 std::uint32_t side);

/// The share of the light that is seen from the origin, behind the ball, and how far it is off with
/// this many samples, well-spread and independent: root mean squares of 64 seeds.
[[nodiscard]] Vec3 share_and_errors(const Light& light, const Sphere& ball, std::uint32_t count);

/// The owl of paper: that of scenes/meshes/owl_cage.obj, in triangles.
[[nodiscard]] Mesh owl();

/// A box of the hierarchy over a mesh. It contains boxes, or triangles.
struct HierarchyBox {
    BoundingBox box;
    std::uint32_t parent = 0;  ///< the place in the list of the box around it
    std::vector<std::uint32_t> triangles;
};

/// The boxes of the owl's hierarchy, each behind its parent.
[[nodiscard]] std::vector<HierarchyBox> owl_hierarchy();

}  // namespace rt::book

namespace rt::contract {

template <>
inline constexpr auto record<book::HierarchyBox> =
    record_of("HierarchyBox", field("box", &book::HierarchyBox::box),
              field("parent", &book::HierarchyBox::parent),
              field("triangles", &book::HierarchyBox::triangles));

/// Stage 0 are the figures' own functions.
template <>
struct Contract<0> {
    template <class Shape>
    using Explain = book::Text (*)(const Ray&, const Shape&, Interval);
    template <class Shape>
    using Shade = std::optional<ShadingPoint> (*)(const Ray&, const Shape&);

    using Functions = std::tuple<
        Function<"explain", Explain<Sphere>(book::explain_shape)>,
        Function<"explain", Explain<Plane>(book::explain_shape)>,
        Function<"explain", Explain<Triangle>(book::explain_shape)>,
        Function<"explain", Explain<Square>(book::explain_shape)>,
        Function<"explain", Explain<Cylinder>(book::explain_shape)>,
        Function<"explain", Explain<Cone>(book::explain_shape)>,
        Function<"explain", Explain<OrientedBox>(book::explain_shape)>,
        Function<"explain_screen", book::explain_screen>,
        Function<"explain_light", book::explain_light>,
        Function<"image_to_world", book::image_to_world>,
        Function<"printed_basis", book::printed_basis>,
        Function<"intersect_with_epsilon", book::intersect_with_epsilon>,
        Function<"shade", Shade<Sphere>(book::shade)>, Function<"shade", Shade<Plane>(book::shade)>,
        Function<"shade", Shade<Triangle>(book::shade)>,
        Function<"printed_shadow_ray", book::printed_shadow_ray>,
        Function<"well_spread_sample", book::well_spread_sample>,
        Function<"independent_sample", book::independent_sample>,
        Function<"lit_ball", book::lit_ball>, Function<"share_and_errors", book::share_and_errors>,
        Function<"owl", book::owl>, Function<"owl_hierarchy", book::owl_hierarchy>>;
};

}  // namespace rt::contract
