#include "common/tuning/scene_traits.hpp"

#include "common/render/stage.hpp"
#include "common/stages/stages.hpp"
#include "common/system/parallel_for.hpp"
#include "common/tuning/input_rounding.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <ctime>

namespace rt {

namespace {

template <class Shape>
std::size_t count(const Shape& /*shape*/) {
    return 1;
}
std::size_t count(const PlacedMesh& placed) {
    return placed.model->mesh.triangles.size();
}

template <class Shape>
void take_in(Demands& demands, const Items<Shape>& items) {
    for (const auto& [shape, material] : items) {
        if (material.specular > 0)
            demands.shininess = std::max(demands.shininess, double(material.shininess));
        demands.strongest_mirror = std::max(demands.strongest_mirror, double(material.mirror));
        demands.shapes += count(shape);
    }
    if (Bounded<Shape> && items.size() > demands.most_alike) {
        demands.most_alike = items.size();
        demands.hierarchy_from = hierarchy_pays_from<Shape>;
    }
}

/// The pixel that seeds the random samples; outside the picture from the second round on, so that
/// the seeds differ.
Pixel seed_pixel(Pixel pixel, Resolution size, int round) {
    return {.row = pixel.row + round * size.height, .column = pixel.column};
}

Shade shade(const Color& color) {
    const auto shown = [](Real value) {
        return std::isnan(value) ? double(value) : 255 * std::clamp(double(value), 0.0, 1.0);
    };
    return {shown(color.r), shown(color.g), shown(color.b)};
}

}  // namespace

Demands demands_of(const Scene& scene, int stage, const Look& look) {
    const InputRounding rounding = input_rounding(scene);
    Demands demands{.extent = rounding.largest,
                    .feature = rounding.smallest,
                    .gap = rounding.gap,
                    .unit_roundoff = unit_roundoff};
    for_each_kind(scene, [&](const auto& items) { take_in(demands, items); });
    take_in(demands, scene.meshes);
    const bool lit = look.shading == Shading::color && stage >= light_stage;
    if (!lit) {
        demands.strongest_mirror = 0;
        demands.shininess = 1;
    }
    for (const Light& light : scene.lights) {
        if (!lit) break;
        demands.sized_lights = demands.sized_lights || light.radius > 0;
    }
    return demands;
}

Shot shot_of(const Scene& scene, const Look& look, const ShotSettings& settings) {
    constexpr std::size_t together = 16;  // pixels in one unit of a thread's work
    const Resolution size = scene.resolution;
    const PixelRays pixel_ray = pixel_rays(scene.cameras.front(), size);
    const std::size_t count = settings.pixels.size();
    Shot shot{.shades = std::vector<Shade>(count), .light_rays = std::vector<int>(count)};
    std::atomic<std::int64_t> rays = 0;
    const std::clock_t start = std::clock();
    const auto draw = [&](std::size_t part) {
        Context context{.look = look};
        const std::size_t end = std::min((part + 1) * together, count);
        for (std::size_t i = part * together; i < end; ++i) {
            const Pixel pixel = settings.pixels[i];
            context.pixel = seed_pixel(pixel, size, settings.round);
            context.sized_light_rays = 0;
            shot.shades[i] = shade(trace(scene, pixel_ray(pixel), context));
            shot.light_rays[i] = int(context.sized_light_rays);
        }
        rays += context.rays;
    };
    in_parallel(settings.threads, (count + together - 1) / together, settings.stop, draw);
    if (count == 0) return shot;
    shot.rays = double(rays) / double(count);
    shot.seconds = double(std::clock() - start) / CLOCKS_PER_SEC / double(count);
    return shot;
}

}  // namespace rt
