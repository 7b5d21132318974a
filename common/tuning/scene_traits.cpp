#include "common/tuning/scene_traits.hpp"

#include "common/render/pixel_samples.hpp"
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
std::size_t count(const MeshInstance& instance) {
    return instance.model->mesh.triangles.size();
}

template <class Shape>
void take_in(SceneTraits& traits, const PrimitiveList<Shape>& primitives) {
    for (const auto& [shape, material] : primitives) {
        if (material.specular > 0)
            traits.shininess = std::max(traits.shininess, double(material.shininess));
        traits.strongest_mirror = std::max(traits.strongest_mirror, double(material.mirror));
        traits.shapes += count(shape);
    }
    if (Bounded<Shape> && primitives.size() > traits.most_alike) {
        traits.most_alike = primitives.size();
        traits.hierarchy_from = bvh_pays_from<Shape>;
    }
}

/// The pixel that seeds the random samples; outside the picture from the second round on, so that
/// the seeds differ.
Pixel seed_pixel(Pixel pixel, Resolution size, int round) {
    return {.row = pixel.row + round * size.height, .column = pixel.column};
}

DisplayColor shade(const Color& color, Gamma gamma) {
    const auto shown = [gamma](Real value) { return 255 * encoded(double(value), gamma); };
    return {shown(color.r), shown(color.g), shown(color.b)};
}

}  // namespace

SceneTraits scene_traits(const Scene& scene, int stage, const RenderSettings& settings) {
    const InputRounding rounding = input_rounding(scene);
    SceneTraits traits{.extent = rounding.largest,
                       .feature = rounding.smallest,
                       .gap = rounding.gap,
                       .unit_roundoff = unit_roundoff};
    for_each_kind(scene, [&](const auto& primitives) { take_in(traits, primitives); });
    take_in(traits, scene.meshes);
    const bool lit = settings.shading == Shading::color && stage >= light_stage;
    if (!lit) {
        traits.strongest_mirror = 0;
        traits.shininess = 1;
    }
    for (const Light& light : scene.lights) {
        if (!lit) break;
        traits.sized_lights = traits.sized_lights || light.radius > 0;
    }
    return traits;
}

PixelSample shot_of(const Scene& scene, const RenderSettings& settings,
                    const SampleRequest& request) {
    constexpr std::size_t together = 16;  // pixels in one unit of a thread's work
    const Resolution size = scene.resolution;
    const PixelRays pixel_ray = pixel_rays(scene.cameras.front(), size);
    const FinerRays finer_rays(scene.cameras.front(), size);
    const bool several = settings.pixel_samples > 1;
    const std::size_t count = request.pixels.size();
    PixelSample shot{.shades = std::vector<DisplayColor>(count),
                     .light_rays = std::vector<int>(count)};
    std::atomic<std::int64_t> rays = 0;
    const std::clock_t start = std::clock();
    const auto draw = [&](std::size_t part) {
        Context context{.settings = several ? shared_settings(settings) : settings};
        const std::size_t end = std::min((part + 1) * together, count);
        for (std::size_t i = part * together; i < end; ++i) {
            const Pixel pixel = request.pixels[i];
            context.pixel = seed_pixel(pixel, size, request.round);
            context.sized_light_rays = 0;
            const Color color = several ? mean_color(scene, finer_rays, pixel, context)
                                        : trace(scene, pixel_ray(pixel), context);
            shot.shades[i] = shade(color, settings.gamma);
            shot.light_rays[i] = int(context.sized_light_rays);
        }
        rays += context.rays;
    };
    parallel_for(request.threads, (count + together - 1) / together, request.stop, draw);
    if (count == 0) return shot;
    shot.rays = double(rays) / double(count);
    shot.seconds = double(std::clock() - start) / CLOCKS_PER_SEC / double(count);
    return shot;
}

}  // namespace rt
