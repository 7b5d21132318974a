// All settings together: the error of a picture, beside one of 1,024 rays through each pixel, and
// its time. From the cheapest settings on, each setting is tried one step finer, and the one that
// removes most error for its time is kept. Afterwards, what each setting's default is wrong by.
#include "common/program/session.hpp"
#include "common/tuning/candidates.hpp"

#include "tests/measurements/accuracy/drawing.hpp"

#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <limits>
#include <map>
#include <sstream>
#include <tuple>

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
    double time = 0;  ///< in units of the default settings'
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
        exact_ = f64::drawn(file_, size, right).image;
    }

    void measure() {
        const SceneTraits traits = session_->traits();
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
        (void)result({});
        for (Cell cell : kept) {
            if (!is_on_front(cell)) continue;
            cell.in_float = true;
            (void)result(cell);
            cell.in_float = false;
            if (traits.most_alike < 2) continue;
            constexpr std::size_t none = 1'000'000;
            cell.hierarchy_from = traits.most_alike < traits.hierarchy_from ? 2 : none;
            // Longer lists are known to be slow.
            if (cell.hierarchy_from == 2 || traits.most_alike <= 100) (void)result(cell);
        }
        choices();
        sources(traits);
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

    [[nodiscard]] Drawing drawn(const Cell& cell) const {
        const auto draw = cell.in_float ? f32::drawn : f64::drawn;
        return draw(file_, size, cell.settings, cell.hierarchy_from);
    }

    /// The time is the shortest of several, each beside one of the default settings.
    const Result& result(const Cell& cell, const char* what = "cell") {
        const auto [known, is_new] = results_.try_emplace(key(cell));
        if (!is_new) return known->second;
        double seconds = std::numeric_limits<double>::infinity();
        double unit = seconds;
        Image image;
        double all = 0;
        for (int turn = 0; turn < 2 || (all < 0.05 && turn < 6); ++turn) {
            unit = std::min(unit, drawn({}).seconds);
            Drawing drawing = drawn(cell);
            seconds = std::min(seconds, drawing.seconds);
            all += drawing.seconds;
            image = std::move(drawing.image);
        }
        known->second = {.time = seconds / unit, .off = difference(image, exact_)};
        print(what, cell, known->second);
        return known->second;
    }

    void print(const char* what, const Cell& cell, const Result& result) const {
        const RenderSettings& settings = cell.settings;
        std::printf("%s,%s,%d,%g,%d,%g,%d,%d,%s,%zu,%.4f,%.4g,%d,%.5f\n", name_.c_str(), what,
                    settings.pixel_error > 0 ? 0 : settings.pixel_samples, settings.pixel_error,
                    settings.shadow_error > 0 ? 0 : settings.shadow_samples, settings.shadow_error,
                    settings.shadow_agree, settings.depth, cell.in_float ? "float" : "double",
                    cell.hierarchy_from, result.time, result.off.error, result.off.most,
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
            if (here.off.error < least_error || here.time > longest) return;
            double best = -std::numeric_limits<double>::infinity();
            std::vector<std::size_t> next;
            for (std::size_t i = 0; i < ladders.size(); ++i) {
                if (steps[i] + 1 == ladders[i].size()) continue;
                std::vector<std::size_t> finer = steps;
                ++finer[i];
                const Result there = result(cell_of(finer));
                const double worth = std::log(here.off.error / there.off.error) /
                                     std::log(std::max(there.time / here.time, 1.02));
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
            return other.second.time < own.time && other.second.off.error < own.off.error;
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

    /// The error of each default, with all else as it is: between a picture with it and one with
    /// the finest.
    void sources(const SceneTraits& traits) const {
        const RenderSettings usual;
        const auto off = [&](const char* what, const Image& a, const Image& b) {
            print(what, {.settings = usual}, {.off = difference(a, b)});
        };
        RenderSettings fine = usual;
        if (traits.sized_lights) fine.shadow_samples = 1024;
        const Image one = drawn({.settings = usual}).image;
        const Image calm = traits.sized_lights ? drawn({.settings = fine}).image : one;
        off("aliasing", calm, exact_);
        off("shadows", one, calm);
        RenderSettings mirrored = usual;
        mirrored.depth = deep;
        off("depth", one, drawn({.settings = mirrored}).image);
        off("precision", one, drawn({.settings = usual, .in_float = true}).image);
        off("input rounding", one, rounded_picture(usual));
    }

    /// The picture, in double, of a scene whose numbers are those of float.
    [[nodiscard]] Image rounded_picture(const RenderSettings& settings) const {
        const std::filesystem::path scenes = RAYSTEPS_ROOT "/scenes";
        const auto path = std::filesystem::temp_directory_path() /
                          ("measure_front." + std::to_string(getpid()) + ".rt");
        std::stringstream whole;
        whole << std::ifstream(file_).rdbuf();
        const std::string text = whole.str();
        std::string rounded;
        for (std::size_t i = 0; i < text.size();) {
            const std::size_t end = std::min(text.find_first_of(" \t\n,:", i), text.size());
            rounded += rounded_word(text.substr(i, end - i), scenes);
            if (end < text.size()) rounded += text[end];
            i = end + 1;
        }
        std::ofstream(path) << rounded;
        Image image = f64::drawn(path.string(), size, settings, 0).image;
        std::filesystem::remove(path);
        return image;
    }

    static std::string rounded_word(const std::string& word, const std::filesystem::path& scenes) {
        if (word.starts_with("meshes/")) return (scenes / word).string();
        double value = 0;
        const char* const end = word.data() + word.size();
        const auto read = std::from_chars(word.data(), end, value);
        if (read.ptr != end || read.ec != std::errc()) return word;
        char text[40];
        std::snprintf(text, sizeof text, "%.17g", double(float(value)));
        return text;
    }

    std::string name_;
    std::string file_;
    std::unique_ptr<Renderer> session_;
    Image exact_;
    std::map<Key, Result> results_;
};

}  // namespace

int main(int count, char** arguments) {
    const std::string only = count > 1 ? arguments[1] : "";
    std::puts(
        "scene,what,samples,pixel_error,shadow_samples,shadow_error,shadow_agree,depth,precision,"
        "hierarchy_from,time,error,most,seen");
    for (const char* scene :
         {"step04_plane", "step08_cone", "step10_shadows", "cornell_box", "step11_soft_shadows"})
        if (only.empty() || only == scene) Study(scene).measure();
}
