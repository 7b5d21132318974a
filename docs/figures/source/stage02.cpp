// Stage 2: the camera's basis in space.
#include "docs/figures/source/figures.hpp"
#include "docs/figures/source/sketch.hpp"

#include "steps/step02_camera_basis/camera_basis.hpp"
#include "steps/step04_plane/plane.hpp"

#include <array>

namespace rt::figures {

namespace {

constexpr Plane ground{.point = {0, 0, 0}, .normal = {0, 1, 0}};

void draw_ground(Sketch& sketch, Vec2 from, Vec2 to) {
    const Pen pen{.color = faint, .width = 1};
    for (Real x = from.x; x <= to.x; ++x) sketch.line({x, 0, from.y}, {x, 0, to.y}, pen);
    for (Real z = from.y; z <= to.y; ++z) sketch.line({from.x, 0, z}, {to.x, 0, z}, pen);
}

/// The screen's pixels, one unit along the rays, and the ground that they show.
void draw_screen(Sketch& sketch, const Basis& basis, Vec3 position) {
    constexpr Resolution resolution{.width = 6, .height = 4};
    const auto ray = [&](int row, int column) {
        return to_world(corner_ray({row, column}, resolution, pi * 2 / 9), basis, position);
    };
    const auto [width, height] = resolution;
    const std::array corners = {ray(0, 0), ray(0, width), ray(height, width), ray(height, 0)};
    const Pen pen{.color = blue, .width = 1, .dashes = "4 4"};
    std::vector<Vec3> seen;
    for (const Ray& corner : corners) seen.push_back(first_hit(corner, ground));
    sketch.polygon(seen, tint, pen);
    for (const Vec3& p : seen) sketch.line(position, p, pen);
    for (int i = 0; i <= height; ++i) sketch.line(at(ray(i, 0), 1), at(ray(i, width), 1), thin);
    for (int j = 0; j <= width; ++j) sketch.line(at(ray(0, j), 1), at(ray(height, j), 1), thin);
}

/// The camera of stage 1: its axes are the world's.
void draw_default_camera(Svg& svg, Vec2 place) {
    Sketch sketch(svg, looking_along({-0.45, -0.42, -1}, place, 44));
    const Basis basis = camera_basis({0, 0, -1});
    const Pen axis{.color = green, .width = 1.5};
    sketch.arrow({0, 0, 0}, -basis.z, {.color = blue, .width = 1.5});
    sketch.arrow({0, 0, 0}, basis.x, axis);
    sketch.arrow({0, 0, 0}, basis.y, axis);
    sketch.arrow({0, 0, 0}, basis.z, axis);
    sketch.mark({0, 0, 0}, Mark::given);
    const TextStyle of_axis{.color = green, .size = 13};
    sketch.label(-basis.z, {0, -6}, "$c$ = (0, 0, −1)",
                 {.color = blue, .anchor = Anchor::start, .size = 13});
    sketch.label(basis.x, {12, 4}, "$X$", of_axis);
    sketch.label(basis.y, {-10, 2}, "$Y$", of_axis);
    sketch.label(basis.z, {-10, 8}, "$Z$", of_axis);
    svg.text(place + Vec2(14, 46), "the default camera", {.color = gray, .size = 13});
}

}  // namespace

std::string camera_axes() {
    Svg svg({640, 372}, "The basis X, Y, Z of a camera that looks down, and its direction c");
    // So that on the page no axis lies along an edge of what the picture shows.
    Sketch sketch(svg, looking_along({0.4, -0.42, -1}, {205, 305}, 96));
    const Vec3 position(0, 2, 0);
    const Basis basis = camera_basis({0.37, -0.82, -0.44});
    const Vec3 c = -basis.z;
    const Pen axis{.color = green, .width = 2.2};

    draw_ground(sketch, {-1, -3}, {4, 1});
    draw_screen(sketch, basis, position);
    sketch.line(position, {0, 0, 0}, dashed);
    sketch.arrow(position, position + Vec3(0, 1, 0), {.color = gray, .width = 1.5});
    sketch.arrow(position, position + c, {.color = blue, .width = 2.2});
    sketch.arrow(position, position + basis.x, axis);
    sketch.arrow(position, position + basis.y, axis);
    sketch.arrow(position, position + basis.z, axis);
    sketch.mark(position, Mark::given);

    const TextStyle of_axis{.color = green};
    const TextStyle before{.color = gray, .anchor = Anchor::end, .size = 13};
    sketch.label(position, {-24, 8}, "$o_C$");
    sketch.label(position + Vec3(0, 1, 0), {-8, 4}, "(0, 1, 0)", before);
    sketch.label(position + c, {14, 6}, "$c$", {.color = blue});
    sketch.label(position + basis.x, {13, 4}, "$X$", of_axis);
    sketch.label(position + basis.y, {12, 4}, "$Y$", of_axis);
    sketch.label(position + basis.z, {-12, 0}, "$Z$", of_axis);
    sketch.label({1, 0, -1}, {12, 8}, "what the picture shows", {.color = gray, .size = 13});
    const TextStyle formula{.color = green, .anchor = Anchor::start};
    svg.text({360, 52}, "$Z$ = −$c$, made unit length", formula);
    svg.text({360, 76}, "$X$ = (0, 1, 0) ∧ $Z$, made unit length", formula);
    svg.text({360, 100}, "$Y$ = $Z$ ∧ $X$", formula);
    draw_default_camera(svg, {520, 172});
    return svg.source();
}

}  // namespace rt::figures
