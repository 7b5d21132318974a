// Stage 2: the effect of an X that is not normalized on the picture.
#include "docs/figures/source/figures.hpp"
#include "docs/figures/source/screen.hpp"
#include "docs/figures/source/sketch.hpp"

#include "steps/step02_camera_basis/camera_basis.hpp"
#include "steps/step03_sphere/sphere.hpp"
#include "steps/step04_plane/plane.hpp"

#include <array>
#include <cmath>
#include <map>

namespace rt::figures {

namespace {

constexpr Resolution small{.width = 48, .height = 32};
constexpr Real pixel_size = 4;

struct BoundingSphere {
    Sphere sphere;
    std::string_view color;
};

constexpr Plane ground{.point = {0, 0, 0}, .normal = {0, 1, 0}};
constexpr std::array balls = {
    BoundingSphere{.sphere = {.center = {0, 0.35, -1.75}, .radius = 0.35}, .color = "#d98a7c"},
    BoundingSphere{.sphere = {.center = {1.1, 0.35, -2.5}, .radius = 0.35}, .color = "#7fa9cf"},
    BoundingSphere{.sphere = {.center = {-1.2, 0.35, -1.2}, .radius = 0.35}, .color = "#e5bf6e"}};

/// The color seen by the ray, of a checkered ground and three spheres on it.
std::string_view seen_color(const Ray& ray) {
    for (const BoundingSphere& ball : balls)
        if (intersect(ray, ball.sphere, {})) return ball.color;
    const Vec3 p = first_hit(ray, ground);
    const Real tile = std::floor(2 * p.x) + std::floor(2 * p.z);
    return std::remainder(tile, 2) == 0 ? "#f1f4f8" : "#dfe5ec";
}

/// The picture through a basis, right or wrong, from its upper left corner on the page.
void draw_picture(Svg& svg, Vec2 corner, const Basis& basis, Vec3 position) {
    std::map<std::string_view, std::vector<Cell>> cells;
    for (int i = 0; i < small.height; ++i)
        for (int j = 0; j < small.width; ++j) {
            const Ray ray = to_world(camera_ray({i, j}, small, pi / 3), basis, position);
            std::vector<Cell>& same = cells[seen_color(ray)];
            const Vec2 place = corner + pixel_size * Vec2(j, i);
            const bool continues =
                !same.empty() && same.back().corner + Vec2(same.back().size.x, 0) == place;
            if (continues)
                same.back().size.x += pixel_size;
            else
                same.push_back({.corner = place, .size = Vec2(pixel_size)});
        }
    for (const auto& [color, same] : cells) svg.cells(same, color);
}

/// The camera of MRT §2 as printed: X is (0, 1, 0) ∧ Z, whatever its length, and Y is Z ∧ X.
Basis printed_basis(Vec3 direction) {
    const Vec3 z = camera_basis(direction).z;
    const Vec3 x = cross(Vec3(0, 1, 0), z);
    return {.x = x, .y = cross(z, x), .z = z};
}

Vec3 pitched(Real degrees) {
    const Real angle = degrees * pi / 180;
    return {0, std::sin(angle), -std::cos(angle)};
}

/// The corners of the printed basis' screen as seen by the right camera, on its picture.
std::vector<Vec2> printed_frame(Vec2 corner, Vec3 direction) {
    const Mat4 to_camera = view_matrix(camera_basis(direction), {0, 0, 0});
    const auto [width, height] = small;
    const Vec2 right_edge = corner_ray({0, 0}, small, pi / 3).direction;
    std::vector<Vec2> frame;
    for (const Pixel pixel : {Pixel{0, 0}, {0, width}, {height, width}, {height, 0}}) {
        const Ray ray = to_world(corner_ray(pixel, small, pi / 3), printed_basis(direction), {});
        const Vec4 p = to_camera * Vec4(ray.direction, 0);
        const Vec2 share = Vec2(p) / -p.z / right_edge;  // 1 at the picture's upper left corner
        frame.push_back(corner + pixel_size * Vec2(width, height) * (Real(1) - share) / Real(2));
    }
    return frame;
}

/// The length of the printed X, and of the normalized one, over the camera's pitch.
void draw_lengths(Svg& svg, Vec2 corner, Vec2 size) {
    const auto place = [=](Real degrees, Real length) {
        return corner + Vec2((degrees + 90) / 180 * size.x, (1 - length) * size.y);
    };
    const auto printed_length = [](Real degrees) {
        return length(printed_basis(pitched(degrees)).x);
    };
    std::vector<Vec2> printed;
    std::vector<Vec2> normalized;
    for (int degrees = -90; degrees <= 90; degrees += 3) {
        printed.push_back(place(degrees, printed_length(degrees)));
        normalized.push_back(place(degrees, length(camera_basis(pitched(degrees)).x)));
    }
    svg.line(place(-90, 0), place(90, 0), thin);
    svg.line(place(-90, 0), place(-90, 1), thin);
    for (const Real value : {Real(0), Real(0.5), Real(1)})
        svg.text(place(-90, value) + Vec2(-6, 4), decimal(value, value == Real(0.5) ? 1 : 0),
                 {.anchor = Anchor::end, .size = 12});
    for (int degrees = -90; degrees <= 90; degrees += 30) {
        svg.line(place(degrees, 0), place(degrees, 0) + Vec2(0, 4), thin);
        if (degrees % 60 == 0)
            svg.text(place(degrees, 0) + Vec2(0, 18), decimal(degrees, 0) + "°", {.size = 12});
    }
    const Vec2 pitch = place(-60, printed_length(-60));
    svg.polyline({place(-90, printed_length(-60)), pitch, place(-60, 0)}, dashed);
    svg.polyline(normalized, {.color = green, .width = 2});
    svg.polyline(printed, {.color = amber, .width = 2});
    svg.circle(pitch, 4, amber, {.color = white, .width = 1});
    svg.text(place(0, 1) + Vec2(0, -8), "‖$X$‖, normalized", {.color = green, .size = 12});
    svg.text(place(0, 0) + Vec2(0, -34), "‖(0, 1, 0) ∧ $Z$‖", {.color = amber, .size = 13});
}

}  // namespace

std::string unnormalized_x() {
    Svg svg({640, 246}, "The length of an X that is not normalized, and the picture it makes");
    const Vec2 size = pixel_size * Vec2(small.width, small.height);
    const Vec3 position(0, 3, 0);
    const Vec3 direction = pitched(-60);
    const Vec2 left(230, 46);
    const Vec2 right(434, 46);
    draw_lengths(svg, {34, 46}, size - Vec2(24, 0));
    draw_picture(svg, left, camera_basis(direction), position);
    draw_picture(svg, right, printed_basis(direction), position);
    svg.polygon(printed_frame(left, direction), none, {.color = amber, .width = 2});
    svg.polygon({right, right + Vec2(size.x, 0), right + size, right + Vec2(0, size.y)}, none,
                {.color = amber, .width = 2});
    const Vec2 below(size.x / 2, size.y + 20);
    const TextStyle note{.color = gray, .size = 13};
    svg.text(left + Vec2(size.x / 2, -12), "$X$ normalized");
    svg.text(right + Vec2(size.x / 2, -12), "$X$ = (0, 1, 0) ∧ $Z$", {.color = amber});
    svg.text(left + below, "pitch −60°: all of the screen", note);
    svg.text(right + below, "the screen shrinks to half,", note);
    svg.text(right + below + Vec2(0, 18), "and all looks twice as large", note);
    svg.text(Vec2(118, 46) + Vec2(0, size.y + 38), "pitch of the camera", note);
    return svg.source();
}

}  // namespace rt::figures
