#include "tests/kit/seen.hpp"

#include "tests/kit/picture.hpp"

#include "common/contract/rendered.hpp"
#include "common/program/load_meshes.hpp"
#include "common/render/render.hpp"
#include "common/scene_file/reader.hpp"

#include "steps/step02_camera_basis/camera_basis.hpp"

#include <cstdlib>
#include <sstream>
#include <tuple>

namespace rt {

namespace {

/// The scene with the elements that all these scenes share.
std::string whole(const std::string& scene) {
    const bool has_camera = scene.find("C ") != std::string::npos;
    return "R 1 1\n" + std::string(has_camera ? "" : "C 0,0,0 0,0,-1 60\n") + scene;
}

/// The lines of a text, indented; only the first 40 of a longer one.
std::string indented(const std::string& lines) {
    constexpr int most = 40;
    std::istringstream in(lines);
    std::string out;
    int count = 0;
    for (std::string line; std::getline(in, line);)
        if (++count <= most) out += "\n              " + line;
    if (count > most) out += "\n              and " + std::to_string(count - most) + " more lines";
    return out;
}

/// The options of the command line that render with these settings: " --term specular".
std::string options_of(const RenderSettings& settings) {
    const RenderSettings defaults;
    std::string options;
    if (settings.shading == Shading::normal) options += " --shade normal";
    if (settings.term == PhongTerm::ambient) options += " --term ambient";
    if (settings.term == PhongTerm::diffuse) options += " --term diffuse";
    if (settings.term == PhongTerm::specular) options += " --term specular";
    for (const auto& [name, value, usual] :
         {std::tuple(" --shadow-samples ", settings.shadow_samples, defaults.shadow_samples),
          std::tuple(" --depth ", settings.depth, defaults.depth)})
        if (value != usual) options += name + std::to_string(value);
    return options;
}

/// What to do with a scene: save it, and render it with these options.
std::string advice(const RenderSettings& settings) {
    const std::string options = options_of(settings);
    return "save it to render it" + (options.empty() ? "" : ", with" + options);
}

/// The color of 255. NaN is drawn, and is no color.
std::string drawn_text(const Color& color) {
    return (is_number(color) ? "" : "NaN, drawn as ") + rt::text(to_rgb(color));
}

Scene scene_of(const std::string& text) {
    // Paths of meshes are relative to the project's folder of scenes.
    Scene scene = parse_scene(text, project_file("scenes/trace.rt"), orthonormal_basis);
    load_meshes(scene);
    // As stages 3 to 8 draw it: a wrong hit outside of the shape's bounding sphere is seen.
    build_acceleration(scene, {.balls = false});
    return scene;
}

}  // namespace

Rgb seen(const std::string& text, const RenderSettings& settings) {
    return to_rgb(seen_unrounded(text, settings));
}

Color seen_unrounded(const std::string& text, const RenderSettings& settings) {
    return traced(scene_of(whole(text)), settings);
}

std::string scene_color(Rgb color) {
    return std::to_string(color[0]) + "," + std::to_string(color[1]) + "," +
           std::to_string(color[2]);
}

std::string pixel_report(const std::string& what, const std::string& scene,
                         const RenderSettings& settings) {
    return what + "\n  scene:    " + advice(settings) + indented(whole(scene));
}

Verdict shows(const std::string& scene, Rgb expected, const RenderSettings& settings,
              int difference) {
    const Color color = seen_unrounded(scene, settings);
    const Rgb got = to_rgb(color);
    bool close = true;
    for (std::size_t i = 0; i < got.size(); ++i)
        close = close && std::abs(got[i] - expected[i]) <= difference;
    return verdict(close, pixel_report("the color of the only pixel, of 255", scene, settings) +
                              "\n  got:      " + drawn_text(color) +
                              "\n  expected: " + text(expected));
}

Image picture_seen(const std::string& text, Resolution resolution, const RenderSettings& settings) {
    Scene scene = scene_of(whole(text));
    scene.resolution = resolution;
    return rendered(scene, settings);
}

Verdict shows_in_every_pixel(const std::string& text, Rgb expected,
                             const RenderSettings& settings) {
    const Image image = picture_seen(text, {.width = 3, .height = 2}, settings);
    for (Pixel pixel; pixel.row < 2; ++pixel.row)
        for (pixel.column = 0; pixel.column < 3; ++pixel.column)
            if (!fits(image[pixel], expected, {0, 0, 0}))
                return verdict(false, "the color of the pixel " + std::to_string(pixel.row) + "," +
                                          std::to_string(pixel.column) +
                                          " of 3 x 2 pixels, of 255" +
                                          "\n  scene:    " + advice(settings) +
                                          "; with R 3 2 as its first line" + indented(whole(text)) +
                                          "\n  got:      " + rt::text(image[pixel]) +
                                          "\n  expected: " + rt::text(expected));
    return {};
}

}  // namespace rt
