#include "common/scene_file/elements.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace rt {
inline namespace RT_PRECISION {

namespace {

void read_resolution(Fields& fields, const ElementReading&, Scene& scene) {
    if (fields.no_number_follows()) return;
    const std::optional<int> width = fields.pixels("width");
    const std::optional<int> height = fields.pixels("height");
    if (width && height) scene.resolution = {.width = *width, .height = *height};
}

void read_ambient(Fields& fields, const ElementReading&, Scene& scene) {
    const Real ratio = fields.ratio("ratio");
    scene.ambient = Ambient{.ratio = ratio, .color = fields.color_or_white()};
}

void read_camera(Fields& fields, const ElementReading& reading, Scene& scene) {
    const Vec3 position = fields.point("position");
    const Vec3 direction = fields.camera_direction("direction");
    scene.cameras.push_back({.position = position,
                             .direction = direction,
                             .fov = fields.angle("field of view"),
                             .fov_axis = reading.fov_axis});
}

/// The basis in the program's axes. It is left-handed if the scene's axes are: shapes placed with
/// it are mirrored.
Basis to_our_axes(const Basis& basis, Axes axes) {
    return {.x = to_our_axes(basis.x, axes),
            .y = to_our_axes(basis.y, axes),
            .z = to_our_axes(basis.z, axes)};
}

void read_light(Fields& fields, const ElementReading&, Scene& scene) {
    const Vec3 position = fields.point("position");
    const Real brightness = fields.ratio("brightness");
    const Color color = fields.color_or_white();
    scene.lights.push_back({.position = position,
                            .brightness = brightness,
                            .color = color,
                            .radius = fields.length_option("radius", 0)});
}

void read_sky(Fields& fields, const ElementReading&, Scene& scene) {
    const Color bottom = fields.color("bottom color");
    scene.sky = Sky{.bottom = bottom, .top = fields.color("top color")};
}

bool is_finite(Vec3 v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Reads the color, which is the last field of a shape, and the options that every shape has.
Material read_material(Fields& fields) {
    const Material plain;
    const Color color = fields.color();
    return {.color = color,
            .specular = fields.ratio_option("spec", plain.specular),
            .shininess = fields.length_option("shin", plain.shininess),
            .mirror = fields.ratio_option("mirror", plain.mirror)};
}

void read_sphere(Fields& fields, const ElementReading&, Scene& scene) {
    const Vec3 center = fields.point("position");
    const Real radius = fields.length("diameter") / 2;
    const Material material = read_material(fields);
    if (fields.is_left_out()) return;
    scene.spheres.push_back({.shape = {.center = center, .radius = radius}, .material = material});
}

void read_plane(Fields& fields, const ElementReading&, Scene& scene) {
    const Vec3 point = fields.point("position");
    const Vec3 normal = fields.direction("normal");
    const Material material = read_material(fields);
    if (fields.is_left_out()) return;
    scene.planes.push_back({.shape = {.point = point, .normal = normal}, .material = material});
}

void read_triangle(Fields& fields, const ElementReading&, Scene& scene) {
    const Vec3 a = fields.point("first corner");
    const Vec3 b = fields.point("second corner");
    const Vec3 c = fields.point("third corner");
    scene.triangles.push_back(
        {.shape = {.a = a, .b = b, .c = c}, .material = read_material(fields)});
}

void read_square(Fields& fields, const ElementReading& reading, Scene& scene) {
    const Vec3 center = fields.point("position");
    const Basis basis = reading.orthonormal_basis(fields.direction("normal"));
    const Real side = fields.length("side");
    const Material material = read_material(fields);
    const bool one_sided = fields.choice("sides", {"2", "1"}) == 1;
    if (fields.is_left_out()) return;
    scene.squares.push_back(
        {.shape = {.center = center, .basis = basis, .side = side, .one_sided = one_sided},
         .material = material});
}

void read_cylinder(Fields& fields, const ElementReading& reading, Scene& scene) {
    const Vec3 position = fields.point("position");
    const Vec3 axis = fields.direction("direction");
    // An early revision of the format has the color at this position.
    const bool early = fields.color_follows();
    const Material early_material = early ? read_material(fields) : Material{};
    const Real radius = fields.length("diameter") / 2;
    const Real height = fields.length("height");
    const Material material = early ? early_material : read_material(fields);
    const Vec3 center = reading.cylinder_from_base ? position + height / 2 * axis : position;
    if (fields.is_left_out()) return;
    if (!is_finite(center)) fields.refuse_line("a cylinder's center is too far away");
    scene.cylinders.push_back(
        {.shape = {.center = center, .axis = axis, .radius = radius, .height = height},
         .material = material});
}

void read_cone(Fields& fields, const ElementReading&, Scene& scene) {
    const Vec3 apex = fields.point("apex");
    const Vec3 axis = fields.direction("direction");
    const Real radius = fields.length("diameter") / 2;
    const Real height = fields.length("height");
    const Material material = read_material(fields);
    if (fields.is_left_out()) return;
    scene.cones.push_back(
        {.shape = {.apex = apex, .axis = axis, .radius = radius, .height = height},
         .material = material});
}

void read_box(Fields& fields, const ElementReading& reading, Scene& scene) {
    const Vec3 center = fields.point("position");
    const Basis basis = reading.orthonormal_basis(fields.direction("direction"));
    const Vec3 size = fields.lengths("size");
    const Material material = read_material(fields);
    if (fields.is_left_out()) return;
    scene.boxes.push_back({.shape = {.center = center, .basis = basis, .half_size = size / Real(2)},
                           .material = material});
}

void read_mesh(Fields& fields, const ElementReading& reading, Scene& scene) {
    MeshRequest mesh{.place = fields.place(), .file = fields.file("file")};
    mesh.placement.translation = fields.point("position");
    if (fields.is_other_layout("scale")) return;
    mesh.placement.scale = fields.length("scale");
    mesh.material = read_material(fields);
    mesh.placement.rotation = to_our_axes(
        reading.orthonormal_basis(fields.direction_option("dir", {0, 0, 1})), reading.axes);
    mesh.smooth = fields.choice("normals", {"smooth", "flat"}) == 0;
    if (fields.is_left_out()) return;
    scene.mesh_requests.push_back(mesh);
}

constexpr const char* last_counts = "the last one counts";
constexpr const char* all_kept = "pictures use the first, or that of --camera N";

constexpr auto table = std::to_array<Element>({
    {{"R", "the resolution", "R width height"}, read_resolution, last_counts},
    {{"A", "the ambient light", "A ratio color"}, read_ambient, last_counts},
    {{"C", "a camera", "C position direction fov"}, read_camera, all_kept},
    {{"c", "a camera", "c position direction fov"}, read_camera},
    {{"L", "a light", "L position brightness color"}, read_light},
    {{"l", "a light", "l position brightness color"}, read_light},
    {{"sky", "the sky", "sky color color"}, read_sky, last_counts},
    {{"sp", "a sphere", "sp position diameter color"}, read_sphere},
    {{"pl", "a plane", "pl position normal color"}, read_plane},
    {{"tr", "a triangle", "tr corner corner corner color"}, read_triangle},
    {{"sq", "a square", "sq position normal side color [sides:1|2]"}, read_square},
    {{"cy", "a cylinder", "cy position direction diameter height color"}, read_cylinder},
    {{"co", "a cone", "co apex direction diameter height color"}, read_cone},
    {{"box", "a box", "box position direction size color"}, read_box},
    {{"mesh", "a mesh", "mesh file position scale color [dir:x,y,z] [normals:smooth|flat]"},
     read_mesh},
});

}  // namespace

std::span<const Element> elements() {
    return table;
}

const Element* find_element(std::string_view keyword) {
    const auto has_keyword = [keyword](const Element& e) { return e.form.keyword == keyword; };
    const auto found = std::ranges::find_if(table, has_keyword);
    return found == table.end() ? nullptr : &*found;
}

}  // namespace RT_PRECISION
}  // namespace rt
