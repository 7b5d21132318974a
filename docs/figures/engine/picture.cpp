// Whole pictures in a page: the text of a scene, rendered as the program of a stage does. An error
// ends the call (thrown.cpp), and the page goes on with a new copy of the module.
#include "docs/figures/engine/picture.hpp"

#include "docs/figures/engine/traces.hpp"

#include "common/mesh_file/load_mesh.hpp"
#include "common/program/load_meshes.hpp"
#include "common/program/requirements.hpp"
#include "common/program/turntable.hpp"
#include "common/render/render.hpp"
#include "common/scene_file/reader.hpp"

#include "steps/step02_camera_basis/camera_basis.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace rt::book {

namespace {

constexpr const char* scene_name = "scene.rt";  // in messages
constexpr Real degree = pi / 180;

std::vector<char> room;
std::string result;
Scene scene;
std::map<std::string, std::string> mesh_files;

void refuse_later_stages(int stage) {
    const std::vector<Requirement> needs = requirements(scene, stage);
    if (needs.empty() || needs.back().stage <= stage) return;
    throw InputError({scene_name}, needs.back().what + " in the scene, which " +
                                       std::string(stage_name(needs.back().stage)) + " introduces");
}

/// The direction, turned to the right about the vertical, and then upwards as far as it goes.
Vec3 turned_direction(Vec3 direction, double right, double up) {
    const Real yaw = std::atan2(direction.x, -direction.z) + Real(right) * degree;
    const Real level = std::hypot(direction.x, direction.z);
    const Real pitch =
        std::clamp(std::atan2(direction.y, level) + Real(up) * degree, -pi / 2, pi / 2);
    return {std::sin(yaw) * std::cos(pitch), std::sin(pitch), -std::cos(yaw) * std::cos(pitch)};
}

/// The element of the camera, in the format of scenes.
std::string camera_line(const Camera& camera) {
    const Vec3 place = to_its_axes(camera.position, scene.axes);
    const Vec3 way = to_its_axes(camera.direction, scene.axes);
    std::array<char, 512> line{};
    std::snprintf(line.data(), line.size(), "C %.6f,%.6f,%.6f %.6f,%.6f,%.6f %.6g", double(place.x),
                  double(place.y), double(place.z), double(way.x), double(way.y), double(way.z),
                  double(camera.fov / degree));
    return line.data();
}

/// The words of a text, in order.
class Words {
public:
    explicit Words(const std::string& text) : rest_(text) {}

    template <class Number>
    Number next() {
        rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t\r\n"), rest_.size()));
        char* end = nullptr;
        const Number number = Number(std::strtod(rest_.data(), &end));
        if (end == rest_.data()) throw InputError({}, "a mesh ends too early");
        rest_.remove_prefix(std::size_t(end - rest_.data()));
        return number;
    }

private:
    std::string_view rest_;
};

}  // namespace

}  // namespace rt::book

namespace rt {

std::string path_of(const MeshRequest& mesh) {
    return mesh.file;
}

void RT_PRECISION::warn_of_turned_triangles(const Mesh&, const std::string&, const Warn&) {}

/// In place of the readers of mesh files: OFF files of triangles, as scenes/meshes has them.
Mesh RT_PRECISION::load_mesh(const std::string& file, const Warn& /*warn*/, bool /*smooth*/) {
    const auto found = book::mesh_files.find(file);
    if (found == book::mesh_files.end() || !found->second.starts_with("OFF"))
        throw InputError({file}, "a page can draw OFF files of the course only");
    const std::string content = found->second.substr(3);
    book::Words words(content);
    Mesh mesh;
    mesh.vertices.resize(words.next<std::size_t>());
    mesh.triangles.resize(words.next<std::size_t>());
    words.next<int>();  // edges
    for (Vec3& vertex : mesh.vertices)
        for (int axis = 0; axis < 3; ++axis) vertex[axis] = Real(words.next<float>());
    for (auto& corners : mesh.triangles) {
        if (words.next<int>() != 3) throw InputError({file}, "a page can draw triangles only");
        for (std::uint32_t& corner : corners) {
            corner = words.next<std::uint32_t>();
            if (corner >= mesh.vertices.size()) throw InputError({file}, "no such vertex");
        }
    }
    return mesh;
}

}  // namespace rt

char* picture_room(std::size_t size) {
    rt::book::room.resize(size);
    return rt::book::room.data();
}

const char* picture_result() {
    return rt::book::result.data();
}

void picture_mesh(std::size_t name_size) {
    using namespace rt::book;
    mesh_files[{room.data(), name_size}] = {room.data() + name_size, room.size() - name_size};
}

std::size_t picture_read(int stage) {
    using namespace rt::book;
    result.clear();
    const auto warn = [](const std::string& warning) { result += warning + "\n"; };
    scene = rt::parse_scene({room.data(), room.size()}, scene_name, rt::orthonormal_basis,
                            {.warn = warn});
    refuse_later_stages(stage);
    rt::load_meshes(scene, nullptr);
    rt::Acceleration how;
    how.balls = stage >= rt::light_stage;  // as the program does
    rt::build_acceleration(scene, how);
    choose_stage(stage);
    return result.size();
}

int picture_height(int width) {
    const auto [across, down] = rt::book::scene.resolution;
    return std::clamp(int(std::lround(double(width) * down / across)), 1, 2 * width);
}

std::size_t picture_draw(int width) {
    using namespace rt::book;
    rt::Scene& scene = rt::book::scene;
    const rt::Resolution own = scene.resolution;
    scene.resolution = {.width = width, .height = picture_height(width)};
    const rt::Image image = rendered(scene);
    scene.resolution = own;
    result.clear();
    for (const auto& [r, g, b] : image.pixels)
        for (const int component : {int(r), int(g), int(b), 255}) result += char(component);
    return result.size();
}

std::size_t picture_camera(double right, double up, double around) {
    using namespace rt::book;
    rt::Camera camera = scene.cameras.front();
    const auto middle = rt::middle_of_shapes(scene);
    if (middle) camera = turned(camera, *middle, rt::Real(around / 360));
    camera.direction = turned_direction(camera.direction, right, up);
    result = camera_line(camera);
    return result.size();
}
