// All settings together: the error of a picture, beside one of 1,024 rays through each pixel, and
// its time. From the cheapest settings on, the neighbors of all that no others beat are tried: each
// setting finer and coarser, and settings that depend on each other in pairs, as a number of rays
// and the error at which they stop; in steps that become smaller.
#include "common/program/renderer.hpp"
#include "common/tuning/candidates.hpp"

#include "tests/measurements/accuracy/time_ratio.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <tuple>
#include <utility>

using namespace rt;

namespace {

constexpr Resolution size{.width = 64, .height = 48};
constexpr double longest = 40;  ///< in units of the default settings' time
constexpr double least_error = 0.7;
constexpr int deep = 64;

/// Settings, and what only the program's options say.
struct Cell {
    RenderSettings settings;
    bool in_float = false;
    std::size_t hierarchy_from = 0;  ///< 0 for the default
};

struct Result {
    TimeRatio ratio;  ///< in units of the default settings' time, without its image
    Difference off;
};

/// Finer values of one setting, from the cheapest on.
using Ladder = std::vector<std::function<void(RenderSettings&)>>;

Ladder most_rays() {
    Ladder ladder;
    for (const int count :
         {1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128, 192, 256, 384, 512, 768, 1024})
        ladder.push_back([=](RenderSettings& settings) { settings.pixel_samples = count; });
    return ladder;
}

/// Errors at which the rays through a pixel stop, and none, which sends all.
Ladder pixel_errors() {
    Ladder ladder;
    for (double error = 64; error > 0.4; error /= std::sqrt(2))
        ladder.push_back([=](RenderSettings& settings) {
            const bool several = settings.pixel_samples > 1;
            settings.pixel_error = several ? std::round(100 * error) / 100 : 0;
        });
    ladder.push_back([](RenderSettings& settings) { settings.pixel_error = 0; });
    return ladder;
}

Ladder most_shadow_rays() {
    Ladder ladder;
    for (int count = 1; count <= 256; count *= 2)
        ladder.push_back([=](RenderSettings& settings) { settings = with_rays(settings, count); });
    return ladder;
}

/// The same for the rays to a light.
Ladder shadow_errors() {
    Ladder ladder;
    for (double error = 16; error > 0.9; error /= 2)
        ladder.push_back([=](RenderSettings& settings) {
            if (settings.shadow_samples == 1) return;
            settings.shadow_error = error;
            settings.shadow_agree = error > 5 ? 8 : 32;
        });
    ladder.push_back([](RenderSettings&) {});
    return ladder;
}

Ladder depths() {
    Ladder ladder;
    for (const int depth : {0, 1, 2, 4, 8})
        ladder.push_back([=](RenderSettings& settings) { settings.depth = depth; });
    return ladder;
}

class Study {
public:
    explicit Study(const std::string& name)
        : name_(name), file_(RAYSTEPS_ROOT "/scenes/" + name + ".rt") {
        Options options{};
        options.scene = file_;
        options.size = size;
        session_ = f64::make_renderer(program, options);
        traits_ = session_->traits();
        RenderSettings right{.pixel_samples = 1024, .depth = deep};
        if (traits_.sized_lights) right = with_rays(right, 16 * 32);  // the root of 1,024 is 32
        exact_ = drawn({.settings = right}).image;
        ladders_ = {most_rays(), pixel_errors()};
        if (traits_.sized_lights)
            ladders_.insert(ladders_.end(), {most_shadow_rays(), shadow_errors()});
        if (traits_.strongest_mirror > 0) ladders_.push_back(depths());
    }

    void measure() {
        for (int count = 1; count <= 256; count *= 4)  // how a mere number of rays compares
            (void)result({.settings = {.pixel_samples = count}}, "cell", true);
        search(4);
        search(2);
        if (ladders_.size() == 2) search(1);  // with more settings this would take minutes
        for (const Steps& steps : front()) {
            Cell cell = cell_of(steps);
            cell.in_float = true;
            (void)result(cell);
            cell.in_float = false;
            if (traits_.shapes < 2 || traits_.shapes > 100) continue;  // long lists are slow
            for (const std::size_t hierarchy_from : {std::size_t(2), std::size_t(1'000'000)}) {
                cell.hierarchy_from = hierarchy_from;
                (void)result(cell);
            }
        }
        choices();
        print();
    }

private:
    inline static const Program program{.stage = 13, .root = RAYSTEPS_ROOT};

    using Key = std::tuple<int, double, int, double, int, int, bool, std::size_t>;
    using Steps = std::vector<std::size_t>;  ///< the place in each ladder

    static Key key(const Cell& cell) {
        const RenderSettings& settings = cell.settings;
        return {settings.pixel_samples, settings.pixel_error,  settings.shadow_samples,
                settings.shadow_error,  settings.shadow_agree, settings.depth,
                cell.in_float,          cell.hierarchy_from};
    }

    [[nodiscard]] Drawing drawn(const Cell& cell) {
        Drawer& draw = drawers_[{cell.in_float, cell.hierarchy_from}];
        if (!draw)
            draw = (cell.in_float ? f32::drawer : f64::drawer)(file_, size, cell.hierarchy_from);
        return draw(cell.settings);
    }

    Drawing drawn_unit() {
        Drawing unit = drawn({});
        unit_seconds_ = std::min(unit_seconds_, unit.seconds);
        return unit;
    }

    /// Settings that a single run shows to be far behind others are not measured in turns.
    const Result& result(const Cell& cell, const std::string& what = "cell",
                         bool in_turns = false) {
        const auto [known, is_new] = results_.try_emplace(key(cell));
        if (!is_new) return known->second;
        (void)drawn_unit();
        const Drawing once = drawn(cell);
        Result own;
        own.off = difference(once.image, exact_);
        own.ratio.time = once.seconds / unit_seconds_;
        constexpr double far = 1.25;  // a single run
        if (in_turns || !is_behind(own, far)) {
            own.ratio = time_ratio([&] { return drawn(cell); }, [&] { return drawn_unit(); });
            own.ratio.image = {};
            measured_.push_back({.what = what, .cell = cell, .is_chosen = in_turns});
        }
        return known->second = std::move(own);
    }

    /// Returns whether others are that much faster, and no less accurate.
    [[nodiscard]] bool is_behind(const Result& own, double far) const {
        return own.ratio.time > longest || std::ranges::any_of(results_, [&](const auto& other) {
                   const double time = other.second.ratio.time;
                   return time > 0 && far * time < own.ratio.time &&
                          other.second.off.error <= own.off.error;
               });
    }

    /// Prints what is on the front or close to it, and what was chosen before.
    void print() const {
        constexpr double far = 1.1;
        for (const auto& [what, cell, is_chosen] : measured_) {
            const Result& own = results_.at(key(cell));
            if (is_chosen || !is_behind(own, far)) print(what, cell, own);
        }
    }

    void print(const std::string& what, const Cell& cell, const Result& result) const {
        const RenderSettings& settings = cell.settings;
        const TimeRatio& ratio = result.ratio;
        std::printf("%s,%s,%d,%g,%d,%g,%d,%d,%s,%zu,%.4f,%.4f,%.4f,%.4g,%d,%.5f\n", name_.c_str(),
                    what.c_str(), settings.pixel_samples, settings.pixel_error,
                    settings.shadow_samples, settings.shadow_error, settings.shadow_agree,
                    settings.depth, cell.in_float ? "float" : "double", cell.hierarchy_from,
                    ratio.time, ratio.least, ratio.greatest, result.off.error, result.off.most,
                    result.off.seen);
        std::fflush(stdout);
    }

    [[nodiscard]] Cell cell_of(const Steps& steps) const {
        Cell cell;
        for (std::size_t i = 0; i < steps.size(); ++i) ladders_[i][steps[i]](cell.settings);
        return cell;
    }

    /// The settings tried that no others beat, but for those more accurate than anybody wants.
    [[nodiscard]] std::vector<Steps> front() {
        std::vector<Steps> too_long;  // and all that are no coarser in any setting
        std::erase_if(tried_, [&](const Steps& steps) {
            if (std::ranges::any_of(too_long, [&](const Steps& coarser) {
                    return std::ranges::equal(coarser, steps, std::less_equal<>());
                }))
                return true;
            if (result(cell_of(steps)).ratio.time > longest) too_long.push_back(steps);
            return false;
        });
        std::vector<Steps> best;
        for (const Steps& steps : tried_) {
            const Result& own = result(cell_of(steps));
            if (own.off.error >= least_error && own.ratio.time <= longest &&
                std::ranges::none_of(results_, [&](const auto& other) {
                    return other.second.ratio.time < own.ratio.time &&
                           other.second.off.error <= own.off.error;
                }))
                best.push_back(steps);
        }
        return best;
    }

    /// Tries the neighbors of all settings on the front, until it stays.
    void search(std::size_t stride) {
        std::set<Steps> searched;
        tried_.insert(Steps(ladders_.size()));  // the cheapest
        for (bool again = true; std::exchange(again, false);)
            for (const Steps& steps : front()) {
                if (!searched.insert(steps).second) continue;
                again = true;
                add_neighbors(steps, stride);
            }
    }

    void add_neighbors(const Steps& steps, std::size_t stride) {
        const auto moved = [&](Steps from, std::size_t i, bool finer) {
            const std::size_t last = ladders_[i].size() - 1;
            const std::size_t step = last < 5 ? 1 : stride;
            from[i] = finer ? std::min(from[i] + step, last) : from[i] - std::min(from[i], step);
            return from;
        };
        for (std::size_t i = 0; i < steps.size(); ++i)
            for (const bool finer : {false, true}) {
                tried_.insert(moved(steps, i, finer));
                if (i % 2 == 0) continue;  // the others are errors, of the rays before
                for (const bool more : {false, true})
                    tried_.insert(moved(moved(steps, i, finer), i - 1, more));
            }
    }

    /// The settings that --tolerance chooses.
    void choices() {
        const std::atomic<bool> going_on = false;
        for (const int tolerance : {1, 2, 4, 8}) {
            Aim aim;
            aim.tolerance = tolerance;
            const auto choice = choose(*session_, {}, aim, Clock::now(), going_on);
            const Cell cell{.settings = choice->expected.settings};
            results_.erase(key(cell));
            (void)result(cell, "tolerance " + std::to_string(tolerance), true);
        }
    }

    std::string name_;
    std::string file_;
    std::unique_ptr<Renderer> session_;
    SceneTraits traits_;
    std::vector<Ladder> ladders_;  ///< of pixels, of lights with a size, and of mirrors
    std::map<std::pair<bool, std::size_t>, Drawer> drawers_;
    Image exact_;
    double unit_seconds_ = std::numeric_limits<double>::infinity();  ///< of the default settings
    std::map<Key, Result> results_;
    struct Measured {
        std::string what;
        Cell cell;
        bool is_chosen = false;
    };
    std::vector<Measured> measured_;
    std::set<Steps> tried_;
};

}  // namespace

int main(int count, char** arguments) {
    const std::string only = count > 1 ? arguments[1] : "";
    std::puts(
        "scene,what,samples,pixel_error,shadow_samples,shadow_error,shadow_agree,depth,precision,"
        "hierarchy_from,time,least,greatest,error,most,seen");
    for (const char* scene :
         {"step04_plane", "step08_cone", "step10_shadows", "cornell_box", "step11_soft_shadows",
          "cornell_mirror", "step12_mirror", "step13_meshes"})
        if (only.empty() || only == scene) Study(scene).measure();
}
