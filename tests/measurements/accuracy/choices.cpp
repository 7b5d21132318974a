// Every scene of the project with --tolerance and --time. For a tolerance: the number of pixels
// within it, and the cost of the picture with its trials, beside the cheapest of other candidates
// within it. For a time: the run time of the program.
#include "common/system/cpu_seconds.hpp"
#include "common/tuning/promise.hpp"

#include "tests/measurements/accuracy/certain_shades.hpp"
#include "tests/measurements/accuracy/drawing.hpp"
#include "tests/measurements/child_process.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

using namespace rt;

namespace {

constexpr double tolerances[] = {1, 4};
constexpr double times[] = {1, 3};  ///< seconds
constexpr double infinite = std::numeric_limits<double>::infinity();
const std::atomic<bool> going_on = false;

/// The right colors, and the pixels whose error with one ray per light exceeds each tolerance.
struct Truth {
    const std::vector<DisplayColor>& shades;
    std::vector<std::vector<bool>> in_penumbra;
};

bool is_kept(const DisplayColor& shade, const DisplayColor& right, double tolerance) {
    return std::ranges::equal(
        shade, right, [tolerance](double a, double b) { return std::abs(a - b) <= tolerance; });
}

/// The shares of all pixels, and of those in a penumbra, that are off by no more than a tolerance.
struct Kept {
    double all = 1;
    double in_penumbra = 1;

    [[nodiscard]] bool as_promised() const {
        return all >= 1 - few_pixels && in_penumbra >= 1 - few_in_penumbrae;
    }
};

Kept kept(const TrialSample& sample, const Truth& truth, std::size_t tolerance) {
    std::size_t all = 0;
    std::size_t in_penumbra = 0;
    for (std::size_t i = 0; i < truth.shades.size(); ++i) {
        if (is_kept(sample.shades[i], truth.shades[i], tolerances[tolerance])) continue;
        ++all;
        in_penumbra += truth.in_penumbra[tolerance][i];
    }
    const auto penumbra =
        std::max<std::ptrdiff_t>(std::ranges::count(truth.in_penumbra[tolerance], true), 1);
    return {.all = 1 - double(all) / double(truth.shades.size()),
            .in_penumbra = 1 - double(in_penumbra) / double(penumbra)};
}

/// The least time of a few, if they are short.
TrialSample rendered(const Renderer& session, const RenderSettings& settings) {
    TrialSample best{.seconds = infinite};
    const std::vector<Pixel> pixels = certain_pixels(session.resolution());
    for (double all = 0; all < 0.3; all += best.seconds * double(shades_of_a_scene)) {
        TrialSample sample =
            session.render_pixels(settings, {.pixels = pixels, .round = last_round - 1});
        if (sample.seconds < best.seconds) best = std::move(sample);
    }
    return best;
}

struct Candidate {
    std::string words;
    RenderSettings settings;
};

/// Ladders of candidate, each from cheap to good.
std::vector<std::vector<Candidate>> ladders(bool sized_lights, RenderSettings settings) {
    if (!sized_lights) return {{{"as usual", settings}}};
    std::vector<std::vector<Candidate>> all(3);
    char words[64];
    for (settings.shadow_samples = 1; settings.shadow_samples <= 512;
         settings.shadow_samples *= 2) {
        std::snprintf(words, sizeof words, "--shadow-samples %d", settings.shadow_samples);
        all[0].push_back({words, settings});
    }
    settings.shadow_samples = most_shadow_samples;
    for (std::size_t ladder : {1, 2}) {
        settings.shadow_agree = ladder == 2 ? 32 : 0;
        for (settings.shadow_error = 11; settings.shadow_error > 0.3;
             settings.shadow_error /= std::sqrt(2)) {
            std::snprintf(words, sizeof words, "--shadow-error %.2g%s", settings.shadow_error,
                          ladder == 2 ? " --shadow-agree 32" : "");
            all[ladder].push_back({words, settings});
        }
    }
    return all;
}

/// Candidate within a tolerance, and their cost per pixel.
struct Found {
    Candidate candidate;
    double seconds = infinite;
};

/// The cheapest for each tolerance.
class Search {
public:
    explicit Search(const Truth& truth) : truth_(truth) {}

    void try_all(const Renderer& session) {
        const SceneTraits traits = session.traits();
        // The likely ones first: others are given up as soon as they are more expensive.
        for (const int depth : {8, 6, 4, 3, 2, 1, 0, 16}) {
            for (auto& ladder : ladders(traits.sized_lights, {.depth = depth}))
                for (Candidate& candidate : ladder) {
                    if (traits.strongest_mirror > 0)
                        candidate.words += " --depth " + std::to_string(depth);
                    if (try_one(session, candidate) > 1.2 * found_[0].seconds) break;
                }
            if (traits.strongest_mirror == 0) break;
        }
    }

    /// The best so far, in another precision, or under other hierarchies.
    void try_best(const Renderer& session, const std::string& what) {
        for (Found& found : std::vector(found_.begin(), found_.end())) {
            found.candidate.words = what + " " + found.candidate.words;
            try_one(session, found.candidate);
        }
    }

    [[nodiscard]] const std::vector<Found>& found() const { return found_; }

private:
    double try_one(const Renderer& session, const Candidate& candidate) {
        const TrialSample sample = rendered(session, candidate.settings);
        for (std::size_t i = 0; i < found_.size(); ++i)
            if (sample.seconds < found_[i].seconds && kept(sample, truth_, i).as_promised())
                found_[i] = {candidate, sample.seconds};
        return sample.seconds;
    }

    const Truth& truth_;
    std::vector<Found> found_ = std::vector<Found>(std::size(tolerances));
};

std::vector<Found> cheapest(const Program& program, const Options& options, const Truth& truth) {
    Search search(truth);
    const auto in_double = f64::make_renderer(program, options);
    const auto in_float = f32::make_renderer(program, options);
    search.try_all(*in_double);
    search.try_best(*in_float, "--precision float");
    in_double->build_acceleration(2);
    search.try_best(*in_double, "a hierarchy from two shapes on;");
    constexpr std::size_t longest_list = 64;
    if (in_double->traits().most_alike <= longest_list) {
        in_double->build_acceleration(longest_list + 1);
        search.try_best(*in_double, "lists;");
    }
    return search.found();
}

Truth truth_of(const Renderer& session, const std::vector<DisplayColor>& right) {
    RenderSettings one_ray;
    one_ray.shadow_samples = 1;
    const TrialSample one = rendered(session, one_ray);
    Truth truth{.shades = right, .in_penumbra = {}};
    for (const double tolerance : tolerances) {
        truth.in_penumbra.emplace_back();
        for (std::size_t i = 0; i < right.size(); ++i)
            truth.in_penumbra.back().push_back(!is_kept(one.shades[i], right[i], tolerance));
    }
    return truth;
}

void measure_tolerances(const std::filesystem::path& scene,
                        const std::vector<DisplayColor>& right) {
    const Program program{.stage = 13, .root = RAYSTEPS_ROOT};
    Options options{};
    options.scene = scene.string();
    options.given.pixel_samples = true;
    const Truth truth = truth_of(*f64::make_renderer(program, options), right);
    const std::vector<Found> found = cheapest(program, options, truth);
    for (std::size_t i = 0; i < found.size(); ++i) {
        options.tolerance = tolerances[i];
        const auto session = f64::make_renderer(program, options);
        const Resolution size = session->resolution();
        const double pixels = double(size.width) * size.height;
        std::unique_ptr<Renderer> in_float;
        const auto open_float = [&]() -> Trials& {
            return *(in_float = f32::make_renderer(program, options));
        };
        const double start = cpu_seconds();
        const AutoSettings choice =
            choose(*session, open_float, options, Clock::now(), going_on).value();
        const double trials = cpu_seconds() - start;
        const TrialSample sample =
            rendered(choice.in_float ? *in_float : *session, choice.expected.settings);
        const Kept share = kept(sample, truth, i);
        std::printf("%s,tolerance,%g,%.5f,%.4f,%.4f,%.4f,%s,%.5f\n", scene.stem().c_str(),
                    tolerances[i], share.all, pixels * sample.seconds + trials, trials,
                    pixels * found[i].seconds, found[i].candidate.words.c_str(), share.in_penumbra);
    }
}

void measure_times(const std::filesystem::path& scene, const std::filesystem::path& programs) {
    const auto picture = std::filesystem::temp_directory_path() /
                         ("measure_choices." + std::to_string(getpid()) + ".png");
    for (const double seconds : times) {
        const auto usage = measurements::run(
            {(programs / "step13_meshes_reference_program").string(), scene.string(), "-o",
             picture.string(), "--quiet", "--samples", "1", "--time", std::to_string(seconds)});
        std::printf("%s,time,%g,0,%.4f,0,0,none,0\n", scene.stem().c_str(), seconds, usage.wall);
    }
    std::filesystem::remove(picture);
}

}  // namespace

int main(int count, char** arguments) {
    const std::filesystem::path program = arguments[0];
    const std::string only = count > 1 ? arguments[1] : "";
    const auto beside = program.parent_path() / "measure_certain_shades";
    std::FILE* const other = popen(("'" + beside.string() + "'").c_str(), "r");
    if (other == nullptr) return 1;
    std::puts("scene,goal,asked,kept,seconds,trials,best,candidate,kept_in_penumbrae");
    for (const auto& scene : scenes_for_choices()) {
        const std::vector<DisplayColor> right = read_shades(other);
        if (right.size() < shades_of_a_scene) return 1;
        if (!only.empty() && scene.stem() != only) continue;
        measure_tolerances(scene, right);
        measure_times(scene, program.parent_path());
        std::fflush(stdout);
    }
    return pclose(other);
}
