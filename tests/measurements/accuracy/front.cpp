// All settings together: the error of a picture, beside one of 1,024 rays through each pixel, and
// its time. From the cheapest settings on, each setting is tried one step finer, and the one that
// removes most error for its time is kept.
#include "common/program/renderer.hpp"
#include "common/tuning/candidates.hpp"

#include "tests/measurements/accuracy/time_ratio.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

using namespace rt;

namespace {

constexpr Resolution size{.width = 64, .height = 48};
constexpr double longest = 40;  ///< in units of the default settings' time
constexpr double least_error = 0.5;
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

Ladder numbers_of_rays() {
    Ladder ladder;
    for (int count = 1; count <= 256; count *= 4)
        ladder.push_back([=](RenderSettings& settings) { settings.pixel_samples = count; });
    return ladder;
}

Ladder pixel_errors() {
    Ladder ladder = {[](RenderSettings& settings) { settings.pixel_samples = 1; }};
    for (double error = 32; error > 0.4; error /= 2)
        ladder.push_back([=](RenderSettings& settings) {
            settings.pixel_samples = 1024;
            settings.pixel_error = error;
        });
    return ladder;
}

Ladder shadow_samples() {
    Ladder ladder;
    for (int count = 1; count <= 64; count *= 4)
        ladder.push_back([=](RenderSettings& settings) { settings = with_rays(settings, count); });
    return ladder;
}

Ladder shadow_errors() {
    Ladder ladder = {[](RenderSettings& settings) { settings = with_rays(settings, 1); }};
    for (double error = 16; error > 0.9; error /= 2) {
        const int agree = error > 5 ? 8 : 32;
        ladder.push_back(
            [=](RenderSettings& settings) { settings = to_error(settings, error, agree); });
    }
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
        RenderSettings right{.pixel_samples = 1024, .depth = deep};
        if (session_->traits().sized_lights) right = with_rays(right, 1);
        exact_ = drawn({.settings = right}).image;
    }

    void measure() {
        const SceneTraits traits = session_->traits();
        (void)result({});
        std::vector<Cell> kept;
        for (const Ladder& pixels : {numbers_of_rays(), pixel_errors()}) {
            std::vector<Ladder> ladders = {pixels};
            if (traits.strongest_mirror > 0) ladders.push_back(depths());
            if (!traits.sized_lights) {
                climb(ladders, kept);
                continue;
            }
            ladders.push_back(shadow_samples());
            climb(ladders, kept);
            ladders.back() = shadow_errors();
            climb(ladders, kept);
        }
        for (Cell cell : kept) {
            if (!is_on_front(cell)) continue;
            cell.in_float = true;
            (void)result(cell);
            cell.in_float = false;
            if (traits.shapes < 2 || traits.shapes > 100) continue;  // long lists are slow
            for (const std::size_t hierarchy_from : {std::size_t(2), std::size_t(1'000'000)}) {
                cell.hierarchy_from = hierarchy_from;
                (void)result(cell);
            }
        }
        choices();
    }

private:
    inline static const Program program{.stage = 13, .root = RAYSTEPS_ROOT};

    using Key = std::tuple<int, double, int, double, int, int, bool, std::size_t>;

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

    const Result& result(const Cell& cell, const char* what = "cell") {
        const auto [known, is_new] = results_.try_emplace(key(cell));
        if (!is_new) return known->second;
        TimeRatio ratio = time_ratio([&] { return drawn(cell); }, [&] { return drawn({}); });
        known->second.off = difference(std::exchange(ratio.image, {}), exact_);
        known->second.ratio = std::move(ratio);
        print(what, cell, known->second);
        return known->second;
    }

    void print(const char* what, const Cell& cell, const Result& result) const {
        const RenderSettings& settings = cell.settings;
        const TimeRatio& ratio = result.ratio;
        std::printf("%s,%s,%d,%g,%d,%g,%d,%d,%s,%zu,%.4f,%.4f,%.4f,%.4g,%d,%.5f\n", name_.c_str(),
                    what, settings.pixel_error > 0 ? 0 : settings.pixel_samples,
                    settings.pixel_error, settings.shadow_error > 0 ? 0 : settings.shadow_samples,
                    settings.shadow_error, settings.shadow_agree, settings.depth,
                    cell.in_float ? "float" : "double", cell.hierarchy_from, ratio.time,
                    ratio.least, ratio.greatest, result.off.error, result.off.most,
                    result.off.seen);
        std::fflush(stdout);
    }

    void climb(const std::vector<Ladder>& ladders, std::vector<Cell>& kept) {
        std::vector<std::size_t> steps(ladders.size());
        const auto cell_of = [&](const std::vector<std::size_t>& places) {
            Cell cell;
            for (std::size_t i = 0; i < ladders.size(); ++i) ladders[i][places[i]](cell.settings);
            return cell;
        };
        for (;;) {
            kept.push_back(cell_of(steps));
            const Result here = result(kept.back());
            if (here.off.error < least_error || here.ratio.time > longest) return;
            double best = -std::numeric_limits<double>::infinity();
            std::vector<std::size_t> next;
            for (std::size_t i = 0; i < ladders.size(); ++i) {
                if (steps[i] + 1 == ladders[i].size()) continue;
                std::vector<std::size_t> finer = steps;
                ++finer[i];
                const Result there = result(cell_of(finer));
                const double worth = std::log(here.off.error / there.off.error) /
                                     std::log(std::max(there.ratio.time / here.ratio.time, 1.02));
                if (worth <= best) continue;
                best = worth;
                next = finer;
            }
            if (next.empty()) return;
            steps = next;
        }
    }

    [[nodiscard]] bool is_on_front(const Cell& cell) {
        const Result own = result(cell);
        return std::ranges::none_of(results_, [&](const auto& other) {
            return other.second.ratio.time < own.ratio.time &&
                   other.second.off.error < own.off.error;
        });
    }

    /// The settings that --tolerance chooses.
    void choices() {
        const std::atomic<bool> going_on = false;
        for (const double tolerance : {1, 2, 4, 8}) {
            Aim aim;
            aim.tolerance = tolerance;
            const auto choice = choose(*session_, {}, aim, Clock::now(), going_on);
            const Cell cell{.settings = choice->expected.settings};
            results_.erase(key(cell));
            char what[32];
            std::snprintf(what, sizeof what, "tolerance %g", tolerance);
            (void)result(cell, what);
        }
    }

    std::string name_;
    std::string file_;
    std::unique_ptr<Renderer> session_;
    std::map<std::pair<bool, std::size_t>, Drawer> drawers_;
    Image exact_;
    std::map<Key, Result> results_;
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
