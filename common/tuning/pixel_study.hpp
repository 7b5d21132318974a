// Trial pixels from which the error and the cost of any number of rays through pixels follow.
#pragma once

#include "common/tuning/tradeoff.hpp"
#include "common/tuning/trial_runner.hpp"

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace rt {

/// The largest number of rays through a trial pixel, and with --pixel-error, if none is given. The
/// error of a picture is its difference from the mean of endlessly many rays.
inline constexpr int right_pixel_samples = 1024;

/// No error of a pixel is larger: with it, one ray through each pixel is enough.
inline constexpr double largest_pixel_error = 255;

/// A picture of one ray a pixel, and trial pixels of four kinds: those on an edge of it, those
/// beside one, the others, and those that a shape narrower than a pixel may cover in part. The
/// README describes the estimator. The rays are those of the picture: the mean of the first few is
/// the color of a pixel with any --pixel-error, and the errors of all counts follow from it.
class PixelStudy {
public:
    /// The settings contain those of rays to lights. `allowed` is the largest error of a pixel that
    /// keeps the tolerance. `soft` is whether the rays to a light with a size are chosen.
    PixelStudy(TrialRunner& runner, Trials& trials, const RenderSettings& settings, double allowed,
               bool soft);

    /// The settings to which those of rays through pixels are added.
    [[nodiscard]] const RenderSettings& settings() const { return settings_; }
    [[nodiscard]] double allowed() const { return allowed_; }

    /// The settings of that number of rays through every pixel. Each sends as many to a light as
    /// those through trial pixels.
    [[nodiscard]] RenderSettings with_pixel_samples(int count) const;

    /// Describes the shapes narrower than a pixel, and what trial pixels do not find of them; empty
    /// if there are none.
    [[nodiscard]] std::string details() const;

    /// The rays through the centers of the picture's pixels, and through all trial pixels so far.
    [[nodiscard]] double center_rays() const { return centers_.rays * runner_.pixels(); }
    [[nodiscard]] double spent() const { return spent_; }

    /// The seconds that the rays through the centers took.
    [[nodiscard]] double center_seconds() const {
        return runner_.picture_seconds(centers_.seconds);
    }

    /// Forgets the trial pixels, and traces rays through some, up to right colors whose estimated
    /// error is `right_error`: settings with a --pixel-error of 1.4 times that, or more, can be
    /// compared with them.
    void begin(double right_error);

    /// The kinds of pixels.
    static constexpr std::size_t kinds = 4;

    /// The expected cost and error of a picture.
    struct Outcome {
        double rays = 0;    ///< total, of all kinds, without those through the centers
        double beyond = 0;  ///< estimated share of pixels that do not keep the tolerance
        std::array<double, kinds> doubts{};  ///< what each kind may add, with 95 % confidence

        [[nodiscard]] double at_most() const;  ///< the share, with 95 % confidence
    };

    /// More trial pixels of one kind.
    struct Growth {
        std::size_t kind = 0;
        double rays = 0;
    };

    /// The kind of which as many pixels again remove most doubt for their rays, and the rays of
    /// this and all further growth after which the share is at most `share`, if it is as estimated.
    /// Returns nothing if there are not enough pixels.
    [[nodiscard]] std::optional<Growth> growth(const Outcome& outcome, double share) const;

    /// Traces rays through as many pixels of that kind again.
    void grow(std::size_t kind);

    /// The outcome of settings that differ in pixel_samples and pixel_error only, for an error of a
    /// pixel of up to `allowed`.
    [[nodiscard]] Outcome outcome(const RenderSettings& settings, double allowed) const;
    [[nodiscard]] Outcome outcome(const RenderSettings& settings) const {
        return outcome(settings, allowed_);
    }

    /// The expected time of a picture with these settings, and the error that, with 95 %
    /// confidence, at most one pixel in a hundred exceeds.
    [[nodiscard]] Trial trial(const RenderSettings& settings) const;

    /// Returns whether the mean error of each tile is at most `allowed`. Where few trial pixels
    /// make a doubt, more are traced in that tile.
    [[nodiscard]] bool tiles_keep(const RenderSettings& settings, double allowed);

private:
    struct TrialPixel {
        Pixel place;
        int contrast = 0;       ///< of its surroundings in the picture of one ray a pixel
        double center_off = 0;  ///< error of the ray through the center
        PixelHistory history;
    };

    /// Sums over the trial pixels of one kind, with some settings.
    struct Sums {
        double rays = 0;
        double beyond = 0;   ///< the pixels that do not keep the tolerance
        double squares = 0;  ///< of each trial pixel's part of that
    };

    /// Pixels of one kind.
    struct Stratum {
        int at_least = 0;           ///< rays through each
        int scouts = 0;             ///< other rays that decide whether these are traced
        std::size_t first = 0;      ///< number that is traced first
        double unseen = 1;          ///< the number of pixels like one that scouts may just find
        double rays = 0;            ///< of all kinds, through those traced
        double pixels = 0;          ///< number of them in the picture
        std::vector<Pixel> places;  ///< those that may be traced, in this order
        std::vector<TrialPixel> traced;
        /// By pixel_error, pixel_samples and tolerance: most settings are compared several times.
        /// Empty again when more pixels are traced.
        mutable std::map<std::array<double, 3>, Sums> known;
    };

    /// A trial pixel with some settings, and the random numbers of one run.
    struct Result {
        double error = 0;
        double rays = 0;
    };

    /// Sorts more pixels of the picture by kind. Returns false if all are.
    bool sort_more();
    [[nodiscard]] std::size_t stratum_of(Pixel pixel) const;
    /// Traces the first trial pixels of each kind that has none yet, but has pixels.
    void trace_first();
    /// Traces rays through more pixels of a kind, until as many as wanted are traced, or all known,
    /// or until the time of trials is over: this part of what is left of it.
    void trace_up_to(std::size_t wanted, Stratum& stratum, double part);
    /// The CPU seconds that these trials may still take of those for all.
    [[nodiscard]] double seconds_left() const;
    /// The number of rays through pixels that take about this time, as through their centers.
    [[nodiscard]] double rays_in(double seconds) const;
    [[nodiscard]] std::vector<TrialPixel> traced(std::span<const Pixel> places, int at_least,
                                                 int scouts);
    [[nodiscard]] static Result result(const TrialPixel& pixel, std::size_t run,
                                       const RenderSettings& settings);
    [[nodiscard]] static Sums sums(const Stratum& stratum, const RenderSettings& settings,
                                   double allowed);
    /// Expects small details where the scene has some.
    void expect_details(const SceneTraits& traits);
    [[nodiscard]] bool tile_keeps(int tile, const RenderSettings& settings, double allowed);

    bool soft_;
    TrialRunner& runner_;
    Trials& trials_;
    RenderSettings settings_;
    RenderSettings reference_;
    double allowed_;
    TrialCenters centers_;
    FineShapes fine_;
    bool elsewhere_ = false;             ///< their shadows or reflections may be anywhere
    std::array<Stratum, kinds> strata_;  ///< on edges, beside edges, the others, and fine shapes
    int draws_ = 0;                      ///< of the spread pixels
    std::size_t sorted_ = 0;             ///< pixels
    std::map<int, std::vector<TrialPixel>> tiles_;  ///< those whose mean error was in doubt
    double spent_ = 0;
    double seconds_ = 0;
};

}  // namespace rt
