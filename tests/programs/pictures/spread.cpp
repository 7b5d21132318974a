#include "tests/programs/pictures/spread.hpp"

#include "common/program/load_meshes.hpp"
#include "common/render/render.hpp"
#include "common/scene_file/reader.hpp"

#include "steps/step02_camera_basis/camera_basis.hpp"

#include <random>

namespace rt {

namespace {

constexpr int drawings = 16;
constexpr Real jitter = 4096 * std::numeric_limits<float>::epsilon();  // the suites' in float
constexpr int far = 10'000;  // another pixel, for another random sequence

using Random = std::mt19937;

Vec3 nudged(Vec3 v, Random& random) {
    std::uniform_real_distribution<Real> share(-1, 1);
    return v + jitter * length(v) * Vec3(share(random), share(random), share(random));
}

void take_in(Rgb got, Rgb reference, Rgb& spread) {
    for (std::size_t i = 0; i < got.size(); ++i)
        spread[i] = std::max<std::uint8_t>(
            spread[i], static_cast<std::uint8_t>(std::abs(got[i] - reference[i])));
}

}  // namespace

void RT_PRECISION::widen(Image& spread, const Image& reference, const std::string& name) {
    Scene scene =
        load_scene(RAYSTEPS_ROOT "/scenes/" + name + ".rt", orthonormal_basis, {.strict = true});
    load_meshes(scene);
    build_acceleration(scene);
    const auto pixel_ray = pixel_rays(scene.cameras.front(), reference.resolution);
    Random random(2021);
    Context context;
    const auto [width, height] = reference.resolution;
    for (Pixel pixel; pixel.row < height; ++pixel.row)
        for (pixel.column = 0; pixel.column < width; ++pixel.column)
            for (int i = 0; i < drawings; ++i) {
                Ray ray = pixel_ray(pixel);
                if (i > 0) ray = {nudged(ray.origin, random), nudged(ray.direction, random)};
                context.pixel = {pixel.row + i * far, pixel.column};
                take_in(to_rgb(trace(scene, ray, context)), reference[pixel], spread[pixel]);
            }
}

}  // namespace rt
