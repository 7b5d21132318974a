#include "common/tuning/scene_traits.hpp"

#include "common/render/pixel_samples.hpp"
#include "common/render/refinement.hpp"
#include "common/render/render.hpp"
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

/// The colors of single pixels of a picture.
class PixelTrial {
public:
    PixelTrial(const Scene& scene, const RenderSettings& settings, const TrialRequest& request)
        : scene_(scene),
          settings_(settings),
          request_(request),
          pixel_ray_(pixel_rays(scene.cameras.front(), scene.resolution)),
          finer_rays_(scene.cameras.front(), scene.resolution) {}

    [[nodiscard]] Color color(Pixel pixel) {
        context_.sized_light_rays = 0;
        if (settings_.pixel_error > 0) return adaptive(pixel);
        const bool several = settings_.pixel_samples > 1;
        begin(pixel, several ? shared_settings(settings_) : settings_);
        return several ? mean_color(scene_, finer_rays_, pixel, context_)
                       : trace(scene_, pixel_ray_(pixel), context_);
    }

    [[nodiscard]] PixelHistory history(Pixel pixel) {
        begin(pixel, adaptive_settings(settings_));
        PixelSamples samples(scene_, finer_rays_, pixel, context_);
        const auto before = context_.rays;
        PixelHistory history;
        for (int count = PixelHistory::fewest; count <= settings_.pixel_samples;
             count = PixelHistory::next(count)) {
            samples.trace_to(count);
            history.steps.push_back({.count = count,
                                     .mean = shade(samples.mean(), settings_.gamma),
                                     .error = samples.error(settings_.gamma),
                                     .rays = double(context_.rays - before)});
            if (count >= request_.at_least && history.steps.back().error <= settings_.pixel_error)
                break;
        }
        history.range = samples.range(settings_.gamma);
        return history;
    }

    /// The rays to area lights of the last pixel.
    [[nodiscard]] int light_rays() const { return int(context_.sized_light_rays); }
    [[nodiscard]] std::int64_t rays() const { return context_.rays; }
    /// The rays through other pixels, which only decide where there are edges.
    [[nodiscard]] std::int64_t unused_rays() const { return unused_rays_; }

private:
    void begin(Pixel pixel, const RenderSettings& settings) {
        context_.settings = settings;
        context_.pixel = seed_pixel(pixel, scene_.resolution, request_.round);
    }

    [[nodiscard]] Color adaptive(Pixel pixel) {
        if (request_.at_least == 0) {
            const Color center = center_color(pixel);
            const auto rays = context_.rays;
            const auto light_rays = context_.sized_light_rays;
            const bool beside_edge = is_beside_edge(pixel);
            unused_rays_ += context_.rays - rays;
            context_.rays = rays;
            context_.sized_light_rays = light_rays;
            if (!beside_edge) return center;
        }
        begin(pixel, adaptive_settings(settings_));
        PixelSamples samples(scene_, finer_rays_, pixel, context_);
        trace_to_error(samples, settings_, request_.at_least);
        return samples.mean();
    }

    [[nodiscard]] Color center_color(Pixel pixel) {
        begin(pixel, settings_);
        return trace(scene_, pixel_ray_(pixel), context_);
    }

    /// Returns whether one of the pixels around it, or it, differs from a neighbor: as Refinement,
    /// except for edges that it follows farther.
    [[nodiscard]] bool is_beside_edge(Pixel pixel) {
        constexpr int reach = 2;
        constexpr int side = 2 * reach + 1;
        Image around({.width = side, .height = side});
        const auto clamped = [](int place, int size) { return std::clamp(place, 0, size - 1); };
        for (int row = 0; row < side; ++row)
            for (int column = 0; column < side; ++column) {
                const Pixel there{
                    .row = clamped(pixel.row + row - reach, scene_.resolution.height),
                    .column = clamped(pixel.column + column - reach, scene_.resolution.width)};
                around[{.row = row, .column = column}] =
                    to_rgb(center_color(there), settings_.gamma);
            }
        Refinement refinement(around.resolution, 2 * settings_.pixel_error);
        for (int row = 0; row < side; ++row) refinement.compare(around, row);
        bool is_marked = false;
        for (int row = 1; row + 1 < side; ++row)
            refinement.take(row, [&](Pixel marked) {
                is_marked = is_marked || (1 <= marked.column && marked.column + 1 < side);
                return false;
            });
        return is_marked;
    }

    const Scene& scene_;
    const RenderSettings& settings_;
    const TrialRequest& request_;
    PixelRays pixel_ray_;
    FinerRays finer_rays_;
    Context context_{};
    std::int64_t unused_rays_ = 0;
};

/// The total cost of the pixels of a trial.
struct Cost {
    double rays = 0;
    double unused_rays = 0;
    double seconds = 0;
};

/// Calls draw_one(trial, index) for each pixel of the request.
template <class DrawOne>
Cost draw(const Scene& scene, const RenderSettings& settings, const TrialRequest& request,
          DrawOne draw_one) {
    constexpr std::size_t together = 16;  // pixels in one unit of a thread's work
    const std::size_t count = request.pixels.size();
    std::atomic<std::int64_t> rays = 0;
    std::atomic<std::int64_t> unused_rays = 0;
    const std::clock_t start = std::clock();
    const auto draw_part = [&](std::size_t part) {
        PixelTrial trial(scene, settings, request);
        const std::size_t end = std::min((part + 1) * together, count);
        for (std::size_t i = part * together; i < end; ++i) draw_one(trial, i);
        rays += trial.rays();
        unused_rays += trial.unused_rays();
    };
    parallel_for(request.threads, (count + together - 1) / together, request.stop, draw_part);
    return {.rays = double(rays),
            .unused_rays = double(unused_rays),
            .seconds = double(std::clock() - start) / CLOCKS_PER_SEC};
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

TrialSample render_pixels(const Scene& scene, const RenderSettings& settings,
                          const TrialRequest& request) {
    const std::size_t count = request.pixels.size();
    TrialSample sample{.shades = std::vector<DisplayColor>(count),
                       .light_rays = std::vector<int>(count)};
    const Cost cost = draw(scene, settings, request, [&](PixelTrial& trial, std::size_t i) {
        sample.shades[i] = shade(trial.color(request.pixels[i]), settings.gamma);
        sample.light_rays[i] = trial.light_rays();
    });
    if (count == 0) return sample;
    sample.rays = cost.rays / double(count);
    const double used = cost.rays / std::max(cost.rays + cost.unused_rays, 1.0);
    sample.seconds = used * cost.seconds / double(count);
    return sample;
}

TrialHistories trace_histories(const Scene& scene, const RenderSettings& settings,
                               const TrialRequest& request) {
    TrialHistories histories{.pixels = std::vector<PixelHistory>(request.pixels.size())};
    const Cost cost = draw(scene, settings, request, [&](PixelTrial& trial, std::size_t i) {
        histories.pixels[i] = trial.history(request.pixels[i]);
    });
    histories.rays = cost.rays;
    histories.seconds = cost.seconds;
    return histories;
}

}  // namespace rt
