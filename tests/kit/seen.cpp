#include "tests/kit/seen.hpp"

#include "tests/kit/picture.hpp"

#include "common/contract/rendered.hpp"
#include "common/program/load_meshes.hpp"
#include "common/render/render.hpp"
#include "common/scene_file/reader.hpp"

#include "steps/step02_camera_basis/camera_basis.hpp"

#include <cstdlib>
#include <sstream>

namespace rt {

namespace {

/// The scene with the elements that all these scenes share.
std::string whole(const std::string& scene) {
    const bool has_camera = scene.find("C ") != std::string::npos;
    return "R 1 1\n" + std::string(has_camera ? "" : "C 0,0,0 0,0,-1 60\n") + scene;
}

std::string indented(const std::string& lines) {
    std::istringstream in(lines);
    std::string out;
    for (std::string line; std::getline(in, line);) out += "\n              " + line;
    return out;
}

}  // namespace

Rgb seen(const std::string& text, const RenderSettings& settings) {
    // Paths of meshes are relative to the project's folder of scenes.
    Scene scene = parse_scene(whole(text), project_file("scenes/trace.rt"), orthonormal_basis);
    load_meshes(scene);
    build_acceleration(scene);
    return to_rgb(traced(scene, settings));
}

std::string scene_color(Rgb color) {
    return std::to_string(color[0]) + "," + std::to_string(color[1]) + "," +
           std::to_string(color[2]);
}

Verdict shows(const std::string& scene, Rgb expected, const RenderSettings& settings,
              int difference) {
    const Rgb got = seen(scene, settings);
    bool close = true;
    for (std::size_t i = 0; i < got.size(); ++i)
        close = close && std::abs(got[i] - expected[i]) <= difference;
    return verdict(close, "the color of the only pixel, of 255" +
                              ("\n  scene:    save it to render it" + indented(whole(scene))) +
                              "\n  got:      " + text(got) + "\n  expected: " + text(expected));
}

}  // namespace rt
