#include "common/tuning/penumbrae.hpp"

#include "common/tuning/candidates.hpp"
#include "common/tuning/pixel_errors.hpp"

#include <algorithm>

namespace rt {

namespace {

/// The smallest number of doubtful pixels from which the error is estimated.
constexpr std::size_t fewest = 96;

/// The largest number of draws, in each of which the cells are sampled once more.
constexpr int most_draws = 16;

/// A larger difference between colors with different shadow rays shows a penumbra.
double visible(const TrialRunner& runner) {
    return runner.limit() / 8;
}

class Scan {
public:
    Scan(TrialRunner& runner, const Trials& trials, const RenderSettings& settings)
        : runner_(runner),
          trials_(trials),
          settings_(settings),
          pixels_(runner.spread().pixels()) {}

    Penumbrae penumbrae() {
        std::vector<bool> in_penumbra(pixels_.size());
        const TrialSample one = runner_.render_pixels(trials_, with_rays(settings_, 1), pixels_, 1);
        for (const int rays : one.light_rays) asked_.push_back(rays > 0);
        mark(in_penumbra, asked_, 0);
        if (std::size_t(std::ranges::count(in_penumbra, true)) < fewest / 2) {
            const std::vector<bool> borders = shadow_borders(one);
            for (int draw = 1; draw <= 3; ++draw) mark(in_penumbra, borders, draw);
        }
        return around(in_penumbra);
    }

private:
    /// Marks the given cells in which one ray and four rays give different colors.
    void mark(std::vector<bool>& in_penumbra, const std::vector<bool>& cells, int draw) {
        const std::vector<Pixel> pixels = runner_.spread().pixels(draw);
        std::vector<Pixel> some;
        std::vector<std::size_t> places;
        for (std::size_t i = 0; i < cells.size(); ++i)
            if (cells[i]) {
                some.push_back(pixels[i]);
                places.push_back(i);
            }
        const TrialSample one = runner_.render_pixels(trials_, with_rays(settings_, 1), some, 1);
        const TrialSample four = runner_.render_pixels(trials_, with_rays(settings_, 4), some, 2);
        const std::vector<double> apart = distances(one, four);
        for (std::size_t i = 0; i < places.size(); ++i)
            if (apart[i] > visible(runner_)) in_penumbra[places[i]] = true;
    }

    /// The cells that touch one of a different color where a shape may occlude a light: only there
    /// can a thin penumbra be.
    [[nodiscard]] std::vector<bool> shadow_borders(const TrialSample& sample) const {
        return runner_.spread().differing_neighbors([&](std::size_t a, std::size_t b) {
            return (asked_[a] || asked_[b]) &&
                   distance(sample.shades[a], sample.shades[b]) > runner_.limit();
        });
    }

    [[nodiscard]] Penumbrae around(const std::vector<bool>& in_penumbra) const {
        const std::vector<bool> doubtful = runner_.spread().with_neighbors(in_penumbra);
        Penumbrae result{.draws = 0};
        const auto cells = std::size_t(std::ranges::count(doubtful, true));
        result.share = double(cells) / double(doubtful.size());
        for (std::size_t i = 0; i < doubtful.size(); ++i)
            if (!doubtful[i]) {
                result.clear.push_back(pixels_[i]);
                if (asked_[i]) result.asked.push_back(pixels_[i]);
            }
        if (cells == 0) return result;
        do {
            const std::vector<Pixel> pixels = runner_.spread().pixels(result.draws);
            for (std::size_t i = 0; i < doubtful.size(); ++i)
                if (doubtful[i]) result.doubtful.push_back(pixels[i]);
            ++result.draws;
        } while (result.doubtful.size() < fewest && result.draws < most_draws);
        std::ranges::stable_sort(result.doubtful, {},
                                 [&](Pixel pixel) { return tile_of(pixel, runner_.size()); });
        return result;
    }

    TrialRunner& runner_;
    const Trials& trials_;
    RenderSettings settings_;
    std::vector<Pixel> pixels_;
    std::vector<bool> asked_;  ///< cells whose pixel sends rays to an area light
};

}  // namespace

Penumbrae find_penumbrae(TrialRunner& runner, const Trials& trials,
                         const RenderSettings& settings) {
    return Scan(runner, trials, settings).penumbrae();
}

double share_in_penumbrae(TrialRunner& runner, const Trials& trials,
                          const RenderSettings& settings) {
    constexpr std::size_t enough = 512;
    const std::vector<Pixel> pixels = some_of(runner.spread().pixels(), enough);
    const TrialSample one = runner.render_pixels(trials, settings, pixels, 1);
    const TrialSample other = runner.render_pixels(trials, settings, pixels, 2);
    const std::vector<double> apart = distances(one, other);
    int sending = 0;
    int different = 1;  // one more, which chance may have spared
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        if (one.light_rays[i] == 0) continue;
        ++sending;
        if (apart[i] > visible(runner)) ++different;
    }
    return double(different) / double(sending);
}

}  // namespace rt
