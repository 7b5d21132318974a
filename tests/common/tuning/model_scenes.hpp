// Model scenes with known errors and costs, in place of trials on a real one.
#pragma once

#include "tests/kit/catch.hpp"

#include "common/system/hash.hpp"
#include "common/tuning/auto_settings.hpp"
#include "common/tuning/choices.hpp"

#include <chrono>
#include <cmath>
#include <cstdint>
#include <random>
#include <thread>

namespace rt {

/// A model scene: the errors and costs of all requests follow from a few numbers.
struct ModelScene {
    SceneTraits traits;
    Resolution size{.width = 640, .height = 480};
    double penumbra = 0;  ///< the share of the pixels in one: those farthest to the left
    double shadow = 0;  ///< the share in full shadow, whose rays to lights are in vain: beside them
    double edges = 0;   ///< the share of the pixels on an edge: those farthest to the right
    double lost = 0;  ///< the share of these that no ray through a center leads to: the upper ones
    double estimated = 1;        ///< the part of the error of rays that --pixel-error estimates
    double reflections = 0;      ///< of a ray, if the depth allows them
    double reflection_cost = 1;  ///< in units of ray_cost
    double ray_cost = 1e-7;
    double shadow_ray_cost = 1e-7;
    double other = 0;  ///< the share of the pixels that this precision gets wrong
    std::chrono::milliseconds center_time{0};  ///< by the clock, for the rays through all centers
    double clock_noise = 1;  ///< seconds are too many, or too few, by up to this factor
    std::size_t asked = 0;   ///< pixels
    double spent = 0;        ///< seconds

    [[nodiscard]] double pixels() const { return double(size.width) * double(size.height); }
};

inline constexpr double one_ray_error = 80;  ///< 8-bit steps, of a pixel in a penumbra

/// A model of stage 11: n rays leave n^(−3/4) of the error of one, and the error is about two
/// thirds of the threshold, since sampling stops at powers of two.
inline double rays_for(double error) {
    return std::pow(one_ray_error / error, 4.0 / 3);
}

inline double error_of(const RenderSettings& settings) {
    return settings.shadow_error > 0
               ? std::min(2 * settings.shadow_error / 3, one_ray_error * std::pow(8, -0.75))
               : one_ray_error * std::pow(settings.shadow_samples, -0.75);
}

/// A pixel on an edge: the error of one ray, of which n rays leave n^(−3/4).
inline constexpr double one_center_error = 60;

/// The rays at which --pixel-error stops in a pixel on an edge.
inline int stopped_rays(double pixel_error) {
    int count = first_pixel_samples(pixel_error);
    while (count < 1024 && one_center_error * std::pow(count, -0.75) > pixel_error)
        count = next_pixel_samples(count, 1024);
    return count;
}

/// The light rays of a pixel in a penumbra or shadow, or elsewhere, where nothing blocks the light.
inline double light_rays(const RenderSettings& settings, bool shaded) {
    return shaded ? std::max(rays_for(error_of(settings)), double(settings.shadow_agree)) : 0;
}

/// Seconds of a ray without those to lights, its reflections included.
inline double path_cost(const ModelScene& model, const RenderSettings& settings) {
    const double reflections = std::min(double(settings.depth), model.reflections);
    return model.ray_cost * (1 + model.reflection_cost * reflections);
}

/// Seconds of a pixel.
inline double cost_of(const ModelScene& model, const RenderSettings& settings, bool shaded) {
    return path_cost(model, settings) + model.shadow_ray_cost * light_rays(settings, shaded);
}

/// The cost of the whole picture.
inline double cost_of(const ModelScene& model, const RenderSettings& settings) {
    const double shaded = model.penumbra + model.shadow;
    return model.pixels() * (shaded * cost_of(model, settings, true) +
                             (1 - shaded) * cost_of(model, settings, false));
}

/// Trials on a model scene, with a clock that is wrong by the model's noise.
class ModelTrials : public Trials {
public:
    explicit ModelTrials(ModelScene& model) : model_(model) {}

    [[nodiscard]] Resolution resolution() const override { return model_.size; }
    [[nodiscard]] SceneTraits traits() const override { return model_.traits; }
    [[nodiscard]] double smallest_gap() const override { return model_.traits.lengths.gap; }

    [[nodiscard]] TrialSample render_pixels(const RenderSettings& settings,
                                            const TrialRequest& request) const override {
        if (*request.stop) return {};
        TrialSample sample;
        for (const Pixel pixel : request.pixels) {
            const bool in_penumbra = pixel.column < model_.penumbra * model_.size.width;
            const bool shaded =
                pixel.column < (model_.penumbra + model_.shadow) * model_.size.width;
            const double edge = settings.pixel_samples;
            const double shade = shade_of(pixel, settings, request.round, in_penumbra) +
                                 edge_error(pixel, edge, request.round) +
                                 reflected_light(settings.depth);
            sample.shades.push_back({shade, shade, shade});
            sample.light_rays.push_back(int(std::lround(light_rays(settings, shaded))));
            sample.rays += edge + light_rays(settings, shaded);
            sample.seconds +=
                cost_of(model_, settings, shaded) + (edge - 1) * path_cost(model_, settings);
        }
        const auto count = double(std::max<std::size_t>(request.pixels.size(), 1));
        model_.asked += request.pixels.size();
        model_.spent += sample.seconds;
        sample.rays /= count;
        sample.seconds *= wrong_clock() / count;
        return sample;
    }

    [[nodiscard]] TrialHistories trace_histories(const RenderSettings& settings,
                                                 const TrialRequest& request) const override {
        if (*request.stop) return {};
        TrialHistories histories;
        for (const Pixel pixel : request.pixels) {
            histories.rays += request.scouts;
            histories.pixels.emplace_back();
            if (request.scouts > 0 && !is_on_edge(pixel)) continue;
            histories.pixels.back() = history(pixel, settings, request.at_least);
            histories.rays += 2 * histories.pixels.back().runs[0].back().rays;
        }
        histories.seconds = histories.rays * path_cost(model_, settings);
        model_.asked += request.pixels.size();
        model_.spent += histories.seconds;
        histories.seconds *= wrong_clock();
        return histories;
    }

    [[nodiscard]] TrialCenters render_centers(const RenderSettings& settings,
                                              const TrialRequest& request) override {
        if (*request.stop) return {};
        std::this_thread::sleep_for(model_.center_time);
        centers_ = Image(model_.size);
        for (Pixel pixel; pixel.row < model_.size.height; ++pixel.row)
            for (pixel.column = 0; pixel.column < model_.size.width; ++pixel.column) {
                const bool is_found = is_on_edge(pixel) && !is_lost(pixel);
                const auto level = std::uint8_t(
                    std::lround(100 + (is_found ? deviation(pixel, 0) * one_center_error : 0)));
                centers_[pixel] = {level, level, level};
            }
        return {.image = &centers_, .rays = 1, .seconds = path_cost(model_, settings)};
    }

private:
    /// A pixel on an edge that is found has the right color of the others, and its center another;
    /// one that is lost has another right color, and the center of the others.
    [[nodiscard]] PixelHistory history(Pixel pixel, const RenderSettings& settings,
                                       int at_least) const {
        PixelHistory history;
        const double right =
            100 +
            (is_on_edge(pixel) && is_lost(pixel) ? deviation(pixel, 0) * one_center_error : 0);
        history.runs = {steps(pixel, right, settings.pixel_samples, 0),
                        steps(pixel, right, settings.pixel_samples, most_pixel_samples)};
        std::size_t traced = 0;
        for (const PixelStep& step : history.runs[0]) {
            ++traced;
            if (step.count >= at_least && step.error <= settings.pixel_error) break;
        }
        for (std::vector<PixelStep>& run : history.runs) run.resize(traced);
        return history;
    }
    /// The mean of the first rays is wrong by the error of all, and by one of its own. The errors
    /// of a run are those of deviations from `first` on.
    [[nodiscard]] std::vector<PixelStep> steps(Pixel pixel, double right, int most,
                                               int first) const {
        std::vector<PixelStep> all;
        double off = 0;
        double variance = 0;
        for (int count = most; count > 0; count = before(count)) {
            const double error = is_on_edge(pixel) ? one_center_error * std::pow(count, -0.75) : 0;
            off += std::sqrt(error * error - variance) * deviation(pixel, first + count);
            variance = error * error;
            const double shade = right + off;
            all.push_back({.count = count,
                           .mean = {shade, shade, shade},
                           .error = model_.estimated * error,
                           .rays = double(count)});
        }
        std::ranges::reverse(all);
        return all;
    }
    /// The number of rays of the step before, or 0.
    [[nodiscard]] static int before(int count) {
        int earlier = 0;
        for (int next = PixelHistory::fewest; next < count; next = PixelHistory::next(next))
            earlier = next;
        return earlier;
    }
    [[nodiscard]] bool is_lost(Pixel pixel) const {
        return pixel.row < model_.lost * model_.size.height;
    }
    /// A normal deviate, half of which is the error of rays of that number.
    [[nodiscard]] double deviation(Pixel pixel, int rays) const {
        // A generator of the library takes a hundred times as long to begin.
        const auto place = std::uint32_t(pixel.row * model_.size.width + pixel.column);
        const std::uint32_t seed = mixed_bits(mixed_bits(place + 1) ^ std::uint32_t(rays));
        const auto uniform = [](std::uint32_t bits) { return (bits + 0.5) / 0x1p32; };
        return 0.5 * std::sqrt(-2 * std::log(uniform(seed))) *
               std::cos(2 * 3.141592653589793 * uniform(mixed_bits(seed + 1)));
    }

    [[nodiscard]] bool is_on_edge(Pixel pixel) const {
        return model_.size.width - pixel.column <= model_.edges * model_.size.width;
    }
    [[nodiscard]] double edge_error(Pixel pixel, double rays, int round) const {
        if (!is_on_edge(pixel)) return 0;
        return one_center_error * std::pow(rays, -0.75) * deviation(pixel, -round);
    }
    [[nodiscard]] double shade_of(Pixel pixel, const RenderSettings& settings, int round,
                                  bool in_penumbra) const {
        const auto place = unsigned(pixel.row * model_.size.width + pixel.column);
        std::mt19937 random(place * 7919 + unsigned(round) * 104'729 + 1);
        // The same pixels at any round.
        if (std::fmod(0.618033988749895 * place, 1) < model_.other) return 200;
        if (!in_penumbra) return 100;
        return 100 + error_of(settings) * std::normal_distribution<double>()(random);
    }

    /// The sum of all reflections, each of which is the mirror's part of the one before.
    [[nodiscard]] double reflected_light(int depth) const {
        double sum = 0;
        double part = 100;
        for (int i = 0; i < std::min(double(depth), model_.reflections); ++i)
            sum += part *= model_.traits.strongest_mirror;
        return sum;
    }

    [[nodiscard]] double wrong_clock() const {
        return std::pow(model_.clock_noise, std::uniform_real_distribution<double>(-1, 1)(clock_));
    }

    ModelScene& model_;
    Image centers_;
    mutable std::mt19937 clock_{std::random_device()()};
};

inline constexpr std::atomic<bool> going_on = false;

/// The choice for a model. The number of rays through a pixel is fixed if it has no edges.
inline AutoSettings chosen(ModelScene& model, Aim aim, const OpenFloat& open_float = {}) {
    if (model.edges == 0) aim.given.pixel_samples = true;
    ModelTrials known(model);
    auto choice = choose(known, open_float, aim, Clock::now(), going_on);
    REQUIRE(choice);
    for (const std::string& reason : choice->reasons) UNSCOPED_INFO(reason);
    return std::move(*choice);
}

/// The share of the pixels in a penumbra that are off by more than the tolerance.
inline double beyond(double error, double allowed) {
    return std::erfc(allowed / error / std::sqrt(2));
}

/// The share of the pixels whose 8-bit color is off by more than the tolerance, a whole number,
/// with rays beside edges. A difference d of colors is one of more levels with a chance of
/// d − allowed, from 0 to 1.
inline double beyond_on_edges(const ModelScene& model, double pixel_error, double allowed) {
    constexpr int parts = 64;
    const double error = one_center_error / 2 * std::pow(stopped_rays(pixel_error), -0.75);
    double sum = 0;
    for (int part = 0; part < parts; ++part) sum += beyond(error, allowed + (part + 0.5) / parts);
    return model.edges * sum / parts;
}

/// The guarantee of --tolerance.
inline bool keeps(const ModelScene& model, double error, double allowed) {
    const double share = beyond(error, allowed);
    return share <= 0.1 && model.penumbra * share <= 0.01;
}

inline ModelScene plain() {
    return {.traits = {.lengths = {.largest = 10, .smallest = 1}, .unit_roundoff = 1e-16}};
}

inline ModelScene soft(double penumbra) {
    ModelScene model = plain();
    model.traits.sized_lights = true;
    model.penumbra = penumbra;
    return model;
}

}  // namespace rt
