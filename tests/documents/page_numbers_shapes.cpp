// The numbers of the pages on rays, shapes, meshes and debugging.
#include "common/explain/pixel_log.hpp"
#include "common/program/load_meshes.hpp"
#include "common/render/pixel_values.hpp"
#include "common/render/stage.hpp"
#include "common/scene_file/reader.hpp"

#include "steps/step01_ray_generation/ray_generation.hpp"
#include "steps/step02_camera_basis/camera_basis.hpp"
#include "steps/step03_sphere/sphere.hpp"
#include "steps/step04_plane/plane.hpp"
#include "steps/step05_triangle/triangle.hpp"
#include "steps/step08_cone/cone.hpp"
#include "steps/step13_meshes/meshes.hpp"

#include "tests/documents/page_numbers.hpp"
#include "tests/kit/picture.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace rt {

Knowledge stage1() {
    const double fov = 70 * degree;
    const double top = std::tan(fov / 2);
    // Two pixels on a screen from −2 to 2 are 2 wide each.
    const double middle = (pixel_on_screen({}, {2, 1}, pi / 2).x + 2) / 2;
    return {{"how far a pixel's middle is in it", middle},
            {"a field of view", fov / degree, "°"},
            {"seen with half of the screen", 2 * std::atan(top / 2) / degree, "°"},
            {"seen with tan(FOV)", 2 * std::atan(std::tan(fov)) / degree, "°"},
            {"where the screen is as high as it is far", 2 * std::atan(1) / degree, "°"},
            {"half of it", std::atan(1) / degree, "°"},
            {"where the tangent of the half is infinite", 2 * std::acos(0) / degree, "°"},
            {"one degree less", 2 * std::acos(0) / degree - 1, "°"},
            {"all rays are the same", 0, "°"}};
}

Knowledge stage2() {
    const Vec3 pitched(0, std::sin(60 * degree), std::cos(60 * degree));
    const double length_of_x = length(cross(Vec3(0, 1, 0), pitched));
    const Vec3 before = camera_basis({0, 1, Real(-0.01)}).x;
    const Vec3 after = camera_basis({0, 1, Real(0.01)}).x;
    return {{"‖(0, 1, 0) ∧ Z‖", length_of_x},
            {"X before and after the vertical", std::acos(dot(before, after)) / degree, "°"},
            {"the pitch", std::acos(length_of_x) / degree, "°"},
            {"between the lines of the sky",
             said_in("steps/step02_camera_basis/main.cpp", "std::remainder(angle, ", " * degree"),
             "°"}};
}

Knowledge stage3() {
    // C of a sphere at distance 1000 is just below 1000².
    const double step = 1e6F - std::nextafter(1e6F, 0.0F);
    return {{"between two floats", step},
            {"half of it, rounded away", step / 2},
            {"the radius", std::sqrt(step / 2)},
            {"where a cosine is 0", std::acos(0) / degree, "°"}};
}

Knowledge stage4() {
    const Plane plane{.point = {-2, 2, 2}, .normal = {3, 0, 4}};
    const Ray ray{.origin = {2, -3, 1}, .direction = {-1, 2, -3}};
    const Vec3 n = normal(plane, plane.point);
    const Real t = *intersect(ray, plane, {});
    const Vec3 p = at(ray, t);
    CHECK(close(dot(n, ray.direction), -3));
    const Scene scene = load_scene(project_file("scenes/step04_plane.rt"), orthonormal_basis);
    const Ray low = pixel_rays(scene.cameras.front(), scene.resolution)({194, 320});
    const Real far = *intersect(low, scene.planes.begin()->shape, {});
    return {{"the ground's last row", scene.cameras.front().position.z - at(low, far).z},
            {"n", n.x},
            {"n", n.z},
            {"⟨r_p − r_0, n⟩", dot(plane.point - ray.origin, n)},
            {"t", t},
            {"p", p.x},
            {"p", p.y},
            {"p", p.z}};
}

Knowledge stage8() {
    const double r = 1;
    const double h = 2;
    const Cone as_wide_as_high{.apex = {0, 0, 0}, .axis = {0, 0, 1}, .radius = 1, .height = 1};
    const double across = dot(normal(as_wide_as_high, {1, 0, 1}), Vec3(1, 0, 0));
    return {{"as printed, at z = h", std::sqrt(r / h) * h},
            {"how far the normal leans back", std::acos(across) / degree, "°"}};
}

namespace {

/// The number of triangles in a mesh of the scene, as read from the file.
double triangles(const Scene& scene, const std::string& file) {
    for (std::size_t i = 0; i < scene.mesh_requests.size(); ++i)
        if (scene.mesh_requests[i].file == file)
            return double(
                (scene.meshes.begin() + std::ptrdiff_t(i))->shape.model->mesh.triangles.size());
    return 0;
}

}  // namespace

Knowledge stage13() {
    Scene scene = load_scene(project_file("scenes/step13_meshes.rt"), orthonormal_basis);
    load_meshes(scene);
    build_acceleration(scene);
    // Every fourth pixel is enough for two digits.
    const auto pixel_ray = pixel_rays(scene.cameras.front(), scene.resolution);
    Context context;
    for (Pixel& pixel = context.pixel; pixel.row < scene.resolution.height; pixel.row += 2)
        for (pixel.column = 0; pixel.column < scene.resolution.width; pixel.column += 2)
            (void)trace(scene, pixel_ray(pixel), context);
    CHECK(says("step13_meshes",
               "with " + decimals(triangles(scene, "meshes/owl_cage.obj"), 0) + " and none."));
    return {{"an owl's triangles", triangles(scene, "meshes/owl.off")},
            {"millions of rays", 4e-6 * double(context.rays)},
            {"the scale of CR's listing", cr_mesh_scale},
            {"what is two wide, so scaled", 2 * cr_mesh_scale},
            {"the least t (CR §4.2)", cr_shadow_start},
            {"half-way between normals at right angles", length(Vec3(1, 1, 0) / Real(2))}};
}

namespace {

/// The legend of --shade depth in stage 8: from the smallest distance to the largest, without the
/// farthest twentieth of the pixels.
Knowledge depth_legend() {
    const Scene scene = load_scene(project_file("scenes/step08_cone.rt"), orthonormal_basis);
    const RenderJob job{.settings = {.shading = Shading::depth}};
    const PixelValues values = pixel_values(scene, job).value();
    std::vector<double> depths;
    for (const auto& depth : values.numbers)
        if (depth) depths.push_back(*depth);
    std::sort(depths.begin(), depths.end());
    const double nearest = std::floor(1000 * depths.front()) / 1000;
    const double farthest = std::ceil(100 * depths[depths.size() * 95 / 100]) / 100;
    Knowledge all = {{"the nearest", nearest},
                     {"the nearest's color", 0, "%"},
                     {"the farthest on the scale", farthest},
                     {"the farthest's color", 100, "%"},
                     {"what is left out of the scale", 5, "%"}};
    for (const double depth : {5, 10, 20, 50})
        all.push_back({"the color of " + std::to_string(int(depth)),
                       100 * std::log(depth / nearest) / std::log(farthest / nearest), "%"});
    return all;
}

/// The percentage of the pixels that change if each triangle of stage 5's scene is a parallelogram,
/// in the size of the picture that `check` compares.
double changed_by_parallelograms(Scene scene) {
    scene.resolution = {.width = 128, .height = 96};
    const auto ray_of = pixel_rays(scene.cameras.front(), scene.resolution);
    const auto distances = [&] {
        std::vector<Real> all;
        for (Pixel pixel; pixel.row < scene.resolution.height; ++pixel.row)
            for (pixel.column = 0; pixel.column < scene.resolution.width; ++pixel.column) {
                Real nearest = infinity;
                const auto look = [&](const auto& kind) {
                    for (const auto& each : kind)
                        nearest =
                            intersect(ray_of(pixel), each.shape, {0, nearest}).value_or(nearest);
                };
                look(scene.spheres);
                look(scene.planes);
                look(scene.triangles);
                all.push_back(nearest);
            }
        return all;
    };
    const std::vector<Real> right = distances();
    for (std::size_t i = scene.triangles.size(); i-- > 0;) {
        const auto [a, b, c] = scene.triangles[i].shape;
        scene.triangles.push_back({{b, b + c - a, c}, {}});
    }
    const std::vector<Real> wrong = distances();
    int different = 0;
    for (std::size_t i = 0; i < right.size(); ++i) different += right[i] != wrong[i];
    return 100.0 * different / double(right.size());
}

}  // namespace

Knowledge debugging() {
    const Triangle triangle{.a = {0, 0, 0}, .b = {4, 0, 0}, .c = {0, 4, 0}};
    const Vec3 weights = barycentric(triangle, {3, 3, 0});
    Knowledge all = {{"β", weights.y},
                     {"β + γ", weights.y + weights.z},
                     {"t of the random case, where z is 2.25", 2.25 / (18 / 17.0)}};

    const Scene scene = load_scene(project_file("scenes/step05_triangle.rt"), orthonormal_basis);
    const Ray ray = pixel_rays(scene.cameras.front(), scene.resolution)({231, 398});
    const Triangle& seen = (scene.triangles.begin() + 4)->shape;
    CHECK(content("docs/debugging.md").find(code(seen)) != std::string::npos);
    std::ostringstream log;
    PixelLog teller(log);
    explain(teller, ray, seen);
    for (const Printed& number : numbers_in(log.str()))
        all.push_back({"the story of pixel 231,398", number.value});
    all.push_back({"the pixels of the picture", changed_by_parallelograms(scene), "%"});
    const Knowledge legend = depth_legend();
    all.insert(all.end(), legend.begin(), legend.end());
    return all;
}

}  // namespace rt
