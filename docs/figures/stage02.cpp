// Stage 2: the camera's basis in space, and what an X that is not normalised does to the picture.
#include "docs/figures/figures.hpp"
#include "docs/figures/sketch.hpp"

#include "steps/step01_ray_generation/ray_generation.hpp"
#include "steps/step02_camera_basis/camera_basis.hpp"
#include "steps/step03_sphere/sphere.hpp"
#include "steps/step04_plane/plane.hpp"

#include <array>
#include <cmath>

namespace rt::figures {

namespace {

const Vec3 upwards(0, 1, 0);
constexpr Plane ground{.point = {0, 0, 0}, .normal = {0, 1, 0}};

/// The ray through the upper left corner of a pixel, half-way between two centres.
Ray corner_ray(Pixel pixel, Resolution resolution, Real fov) {
    const Ray before = camera_ray({pixel.row - 1, pixel.column - 1}, resolution, fov);
    const Ray here = camera_ray(pixel, resolution, fov);
    return {.origin = here.origin, .direction = (before.direction + here.direction) / Real(2)};
}

void draw_ground(Sketch& sketch) {
    constexpr int left = -1;
    constexpr int right = 5;
    constexpr int near = 1;
    constexpr int far = -4;
    for (int x = left; x <= right; ++x)
        sketch.line({x, 0, near}, {x, 0, far}, {.color = faint, .width = 1});
    for (int z = far; z <= near; ++z)
        sketch.line({left, 0, z}, {right, 0, z}, {.color = faint, .width = 1});
}

/// The screen's pixels, one step along the rays, and what they see of the ground.
void draw_screen(Sketch& sketch, const Basis& basis, Vec3 position) {
    constexpr Resolution resolution{.width = 6, .height = 4};
    const auto ray = [&](int row, int column) {
        return to_world(corner_ray({row, column}, resolution, pi / 4), basis, position);
    };
    const auto [width, height] = resolution;
    std::vector<Vec3> seen;
    for (const Ray& r : {ray(0, 0), ray(0, width), ray(height, width), ray(height, 0)})
        seen.push_back(first_hit(r, ground));
    sketch.polygon(seen, tint, {.color = blue, .width = 1, .dashes = "4 4"});
    for (const Vec3& p : seen)
        sketch.line(position, p, {.color = blue, .width = 1, .dashes = "4 4"});
    for (int i = 0; i <= height; ++i) sketch.line(at(ray(i, 0), 1), at(ray(i, width), 1), thin);
    for (int j = 0; j <= width; ++j) sketch.line(at(ray(0, j), 1), at(ray(height, j), 1), thin);
}

}  // namespace

std::string camera_basis_axes() {
    Svg svg({640, 420}, "The basis X, Y, Z of a camera that looks down, and its direction c");
    Sketch sketch(svg, looking_along({0.5, -0.35, -0.8}, {200, 330}, 86));
    const Vec3 position(0, 2, 0);
    const Vec3 direction(0.75, -0.55, -0.5);
    const Basis basis = camera_basis(direction);
    const Vec3 c = -basis.z;

    draw_ground(sketch);
    draw_screen(sketch, basis, position);
    sketch.line(position, {0, 0, 0}, dashed);
    const Pen axis{.color = green, .width = 2.2};
    sketch.arrow(position, position + Real(1.2) * upwards, {.color = gray, .width = 1.5});
    sketch.arrow(position, position + c, {.color = blue, .width = 2.2});
    sketch.arrow(position, position + basis.x, axis);
    sketch.arrow(position, position + basis.y, axis);
    sketch.arrow(position, position + basis.z, axis);
    sketch.mark(position, Mark::given);
    return svg.source();
}

namespace {

struct Ball {
    Sphere sphere;
    std::string_view color;
};

constexpr Resolution small{.width = 48, .height = 32};
constexpr Real pixel_size = 4;

/// What the ray sees of a chequered ground and three balls.
std::string_view seen_color(const Ray& ray) {
    static constexpr std::array balls = {
        Ball{.sphere = {.center = {0, 0.35, -1.75}, .radius = 0.35}, .color = "#d98a7c"},
        Ball{.sphere = {.center = {1.1, 0.35, -2.5}, .radius = 0.35}, .color = "#7fa9cf"},
        Ball{.sphere = {.center = {-1.2, 0.35, -1.2}, .radius = 0.35}, .color = "#e5bf6e"}};
    for (const Ball& ball : balls)
        if (intersect(ray, ball.sphere, {})) return ball.color;
    const Vec3 p = first_hit(ray, ground);
    const bool odd = (int(std::floor(2 * p.x)) + int(std::floor(2 * p.z))) % 2 != 0;
    return odd ? "#dfe5ec" : "#f1f4f8";
}

/// The picture through a basis, right or wrong, from its upper left corner on the page.
void draw_picture(Svg& svg, Vec2 corner, const Basis& basis, Vec3 position) {
    for (int i = 0; i < small.height; ++i) {
        int begin = 0;
        std::string_view color;
        for (int j = 0; j <= small.width; ++j) {
            const Ray ray = to_world(camera_ray({i, j}, small, pi / 3), basis, position);
            const std::string_view next = j < small.width ? seen_color(ray) : none;
            if (j > 0 && next != color) {
                svg.cell(corner + pixel_size * Vec2(begin, i), pixel_size * Vec2(j - begin, 1),
                         color);
                begin = j;
            }
            color = next;
        }
    }
}

/// The camera of MRT §2 as printed: X is (0, 1, 0) ∧ Z, whatever its length, and Y is Z ∧ X.
Basis printed_basis(Vec3 direction) {
    const Vec3 z = camera_basis(direction).z;
    const Vec3 x = cross(upwards, z);
    return {.x = x, .y = cross(z, x), .z = z};
}

Vec3 pitched(Real degrees) {
    const Real angle = degrees * pi / 180;
    return {0, std::sin(angle), -std::cos(angle)};
}

/// The length of the printed X, and of the normalised one, over the camera's pitch.
void draw_lengths(Svg& svg, Vec2 corner, Vec2 size) {
    const auto place = [=](Real degrees, Real length) {
        return corner + Vec2((degrees + 90) / 180 * size.x, (1 - length) * size.y);
    };
    std::vector<Vec2> printed;
    std::vector<Vec2> normalised;
    for (int degrees = -90; degrees <= 90; degrees += 3) {
        printed.push_back(place(degrees, length(printed_basis(pitched(degrees)).x)));
        normalised.push_back(place(degrees, length(camera_basis(pitched(degrees)).x)));
    }
    svg.line(place(-90, 0), place(90, 0), thin);
    svg.arrow(place(-90, 0), place(-90, 1) - Vec2(0, 16), thin);
    for (int degrees = -90; degrees <= 90; degrees += 30) {
        svg.line(place(degrees, 0), place(degrees, 0) + Vec2(0, 4), thin);
        if (degrees % 60 == 0 || degrees == 0)
            svg.text(place(degrees, 0) + Vec2(0, 18), decimal(degrees, 0) + "°", {.size = 12});
    }
    svg.polyline(normalised, {.color = green, .width = 2});
    svg.polyline(printed, {.color = amber, .width = 2});
}

}  // namespace

std::string camera_unnormalised() {
    Svg svg({640, 236}, "The length of an X that is not normalised, and the picture it makes");
    const Vec2 size = pixel_size * Vec2(small.width, small.height);
    const Vec3 position(0, 3, 0);
    const Vec3 direction = pitched(-60);
    draw_lengths(svg, {34, 40}, size - Vec2(14, 0));
    draw_picture(svg, {236, 40}, camera_basis(direction), position);
    draw_picture(svg, {440, 40}, printed_basis(direction), position);
    return svg.source();
}

}  // namespace rt::figures
