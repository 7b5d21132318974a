// Every element and option of the format is used by a shipped scene: nothing else is modeled.
#include "common/scene_file/elements.hpp"
#include "common/scene_file/reader.hpp"

#include "steps/step02_camera_basis/camera_basis.hpp"

#include "tests/kit/picture.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

using namespace rt;

namespace {

std::string content(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<std::filesystem::path> shipped_files() {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(project_file("scenes")))
        if (entry.path().extension() == ".rt") files.push_back(entry.path());
    return files;
}

/// The texts between each of the openings and the next of the ends.
std::set<std::string> found(const std::string& text, const std::string& opening,
                            const std::string& ends) {
    std::set<std::string> all;
    for (std::size_t at = text.find(opening); at != std::string::npos;
         at = text.find(opening, at + 1)) {
        const std::size_t begin = at + opening.size();
        all.insert(text.substr(begin, text.find_first_of(ends, begin) - begin));
    }
    return all;
}

const std::vector<Scene>& shipped_scenes() {
    static const std::vector<Scene> scenes = [] {
        std::vector<Scene> all;
        for (const std::filesystem::path& file : shipped_files())
            all.push_back(load_scene(file.string(), orthonormal_basis, {.strict = true}));
        return all;
    }();
    return scenes;
}

/// True if a scene that strict reading accepts satisfies the predicate.
template <class Predicate>
bool any_scene(Predicate predicate) {
    const std::vector<Scene>& scenes = shipped_scenes();
    return std::any_of(scenes.begin(), scenes.end(), predicate);
}

template <class Predicate>
bool any_material(Predicate predicate) {
    return any_scene([&](const Scene& scene) {
        const auto among = [&](const auto& primitives) {
            return std::any_of(primitives.begin(), primitives.end(), [&](const auto& primitive) {
                return predicate(primitive.material);
            });
        };
        return among(scene.spheres) || among(scene.planes) || among(scene.squares);
    });
}

}  // namespace

TEST_CASE("every shipped scene is read by the letter") {
    CHECK(shipped_files().size() >= 29);
    for (const std::filesystem::path& file : shipped_files())
        CHECK_NOTHROW(load_scene(file.string(), orthonormal_basis, {.strict = true}));
}

TEST_CASE("a shipped scene uses every keyword, option and directive") {
    std::string scenes = "\n";
    for (const std::filesystem::path& file : shipped_files()) scenes += content(file) + "\n";
    const std::set<std::string> keywords = found(scenes, "\n", " \t\n");
    for (const Element& element : elements()) {
        INFO(element.form.keyword);
        CHECK(keywords.contains(std::string(element.form.keyword)));
    }
    // Options have no table: they are where they are read.
    const std::string reader = content(project_file("common/scene_file/elements.cpp"));
    std::set<std::string> options = found(reader, "option(\"", "\"");
    options.merge(found(reader, "choice(\"", "\""));
    CHECK(options.size() >= 7);
    for (const std::string& option : options) {
        INFO(option);
        CHECK(scenes.find(" " + option + ":") != std::string::npos);
    }
    CHECK(scenes.find("\n# rt: fov=horizontal cyl=base\n") != std::string::npos);
    CHECK(scenes.find("\n# rt: hand=left up=z\n") != std::string::npos);
}

TEST_CASE("a shipped scene has every kind of shape, and sets every field") {
    CHECK(any_scene([](const Scene& s) { return !s.spheres.empty(); }));
    CHECK(any_scene([](const Scene& s) { return !s.planes.empty(); }));
    CHECK(any_scene([](const Scene& s) { return !s.triangles.empty(); }));
    CHECK(any_scene([](const Scene& s) { return !s.squares.empty(); }));
    CHECK(any_scene([](const Scene& s) { return !s.cylinders.empty(); }));
    CHECK(any_scene([](const Scene& s) { return !s.cones.empty(); }));
    CHECK(any_scene([](const Scene& s) { return !s.boxes.empty(); }));
    CHECK(any_scene([](const Scene& s) { return s.ambient && s.ambient->color != Color(1); }));
    CHECK(any_scene([](const Scene& s) { return s.lights.size() > 1; }));
    CHECK(any_scene([](const Scene& s) { return s.sky && s.sky->bottom != s.sky->top; }));
    CHECK(any_scene([](const Scene& s) { return s.cameras.size() > 1; }));
    CHECK(any_scene([](const Scene& s) { return s.resolution.width != 640; }));
    CHECK(any_scene(
        [](const Scene& s) { return s.cameras.front().fov_axis == FovAxis::horizontal; }));
    CHECK(any_scene([](const Scene& s) {
        return std::any_of(
            s.squares.begin(), s.squares.end(),
            [](const Primitive<Square>& primitive) { return primitive.shape.one_sided; });
    }));
    CHECK(any_scene([](const Scene& s) { return !s.lights.empty() && s.lights[0].radius > 0; }));
    const auto any_mesh = [](auto predicate) {
        return any_scene([predicate](const Scene& s) {
            return std::any_of(s.mesh_requests.begin(), s.mesh_requests.end(), predicate);
        });
    };
    CHECK(any_mesh([](const MeshRequest& mesh) { return mesh.smooth; }));
    CHECK(any_mesh([](const MeshRequest& mesh) { return !mesh.smooth; }));
    CHECK(any_mesh([](const MeshRequest& mesh) { return mesh.placement.scale != 1; }));
    CHECK(any_mesh([](const MeshRequest& mesh) { return mesh.placement.rotation.z.z != 1; }));
    CHECK(any_material([](const Material& material) { return material.specular > 0; }));
    CHECK(any_material(
        [](const Material& material) { return material.shininess != Material{}.shininess; }));
    CHECK(any_material([](const Material& material) { return material.mirror > 0; }));
}
