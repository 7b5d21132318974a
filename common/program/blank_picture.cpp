#include "common/program/make_picture.hpp"

#include "common/explain/text.hpp"
#include "common/math/vector.hpp"
#include "common/render/render.hpp"
#include "common/render/stage.hpp"
#include "common/scene/scene.hpp"
#include "common/stages/stages.hpp"
#include "common/stages/todo.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace rt {

namespace {

/// A smaller picture may well have one color.
constexpr std::size_t least_pixels = 16;
/// The longest sides of the pictures that are tried: all rays would take as long as the picture.
constexpr int most_of_another_camera = 24;
constexpr int most_of_this_camera = 640;
constexpr std::size_t most_cameras_tried = 16;

/// A picture with the same proportions, and with at most this many pixels on a side.
Resolution reduced(Resolution size, int longest) {
    const double factor = std::min(1.0, double(longest) / std::max(size.width, size.height));
    const auto side = [factor](int all) { return std::max(1, int(std::lround(factor * all))); };
    return {.width = side(size.width), .height = side(size.height)};
}

/// The number of rays of the camera's picture, reduced to this longest side, whose color satisfies
/// the condition.
template <class Condition>
int count_rays(const Scene& scene, const Camera& camera, const RenderSettings& settings,
               int longest, Condition satisfies) {
    const Resolution size = reduced(scene.resolution, longest);
    const PixelRays pixel_ray = pixel_rays(camera, size);
    Context context{.settings = settings};
    int count = 0;
    for (int row = 0; row < size.height; ++row)
        for (int column = 0; column < size.width; ++column) {
            context.pixel = {.row = row, .column = column};
            const Ray ray = pixel_ray(context.pixel);
            if (satisfies(ray, to_rgb(trace(scene, ray, context)))) ++count;
        }
    return count;
}

constexpr Rgb black = {0, 0, 0};

/// The number of these rays that hit a shape.
int hits(const Scene& scene, const Camera& camera, RenderSettings settings,
         int longest = most_of_another_camera) {
    settings.shading = Shading::normal;  // in this shading only missed pixels are black, or the sky
    return count_rays(scene, camera, settings, longest, [&scene](const Ray& ray, Rgb color) {
        return color != black && color != to_rgb(background(scene, ray));
    });
}

std::size_t count_shapes(const Scene& scene) {
    std::size_t count = scene.meshes.size();
    for_each_kind(scene, [&count](const auto& primitives) { count += primitives.size(); });
    return count;
}

/// Candidate directions that may see more than the camera's: to the center of the shapes, and along
/// the axes.
std::vector<Vec3> other_directions(const Scene& scene, Vec3 position) {
    std::vector<Vec3> directions;
    const BoundingBox box = box_of_shapes(scene);
    const Vec3 way = box.min / Real(2) + box.max / Real(2) - position;
    const Real size = largest_component(glm::abs(way));
    if (size > 0 && size < infinity) directions.push_back(way / size);
    for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}) {
        directions.push_back(axis);
        directions.push_back(-axis);
    }
    return directions;
}

/// Two decimals: accurate enough to face that way, and short enough to type.
std::string short_text(Vec3 v) {
    const auto digits = [](Real value) { return text(std::round(value * 100) / 100 + Real(0)); };
    return digits(v.x) + "," + digits(v.y) + "," + digits(v.z);
}

Vec3 rounded(Vec3 v) {
    return glm::round(v * Real(100)) / Real(100);
}

std::string why_nothing_is_hit(const Scene& scene, const RenderSettings& settings) {
    const std::string start = "no ray of the camera hits a shape: ";
    const Camera& camera = scene.cameras.front();
    const std::size_t cameras = std::min(scene.cameras.size(), most_cameras_tried);
    for (std::size_t i = 1; i < cameras; ++i)
        if (hits(scene, scene.cameras[i], settings) > 0)
            return start + "another camera sees some; try --camera " + std::to_string(i + 1);

    Camera tried = camera;
    int most = 0;
    Vec3 best(0);
    for (const Vec3& direction : other_directions(scene, camera.position)) {
        if (rounded(direction) == Vec3(0)) continue;
        tried.direction = unit(rounded(direction));
        if (tried.direction == camera.direction) continue;
        const int count = hits(scene, tried, settings);
        if (count <= most) continue;
        most = count;
        best = rounded(direction);
    }
    if (most > 0)
        return start + "it points past them; try the direction " +
               short_text(to_its_axes(best, scene.axes)) + " in its line";
    return start + "they may be too small or too far away; try a position nearer to them";
}

/// Returns whether what is in view is black in any light: its color is, or it is a mirror that
/// shows nothing.
bool is_black_in_any_light(const Scene& scene, RenderSettings settings) {
    Scene bright = scene;
    bright.ambient = Ambient{.ratio = 1};
    settings.term = PhongTerm::all;
    return count_rays(bright, scene.cameras.front(), settings, most_of_another_camera,
                      [](const Ray&, Rgb color) { return color != black; }) == 0;
}

}  // namespace

std::string why_blank(const Scene& scene, const RenderSettings& settings, int stage,
                      const Image& image) {
    const std::vector<Rgb>& pixels = image.pixels;
    const auto differs = [&pixels](Rgb pixel) { return pixel != pixels.front(); };
    if (stage < shapes_stage || pixels.size() < least_pixels || has_said_todo()) return "";
    if (std::ranges::any_of(pixels, differs)) return "";
    const std::string start = "all pixels have one color: ";
    if (count_shapes(scene) == 0)
        return start + "the scene has no shape; try a line such as \"sp 0,0,0 2 255,0,0\"";
    const Camera& camera = scene.cameras.front();
    constexpr Real widest =
        Real(3.14);  // almost all rays of a wider one are parallel to the screen
    if (camera.fov == 0 || camera.fov > widest)
        return start + "the camera's field of view is " + (camera.fov == 0 ? "0" : "180") +
               "; try one of 60";
    if (hits(scene, camera, settings, most_of_this_camera) == 0)
        return start + why_nothing_is_hit(scene, settings);
    const bool lit = stage >= light_stage && settings.shading == Shading::color;
    if (lit && scene.lights.empty() && !scene.ambient)
        return start + "there is no light; try lines A and L, or --shade normal";
    const bool is_black = pixels.front() == black;
    if (lit && is_black && settings.term != PhongTerm::all)
        return start + "--term shows one term of the light, and no shape in view has it";
    if (lit && is_black && is_black_in_any_light(scene, settings))
        return start +
               "what is in view is black in any light: its color is black, or it is a mirror that "
               "shows nothing; try another color, or a smaller mirror:";
    if (lit && is_black)
        return start +
               "shapes are in view, but no light reaches them, or that light is black; try "
               "a line L on the camera's side, or --shade normal";
    if (lit && pixels.front() == Rgb{255, 255, 255})
        return start + "the lights add up to more than white; try smaller ratios in A and L";
    return start +
           "one surface fills the picture, or the camera is inside a shape; try another "
           "position in its line";
}

}  // namespace rt
