// What --tolerance and --time choose, for made-up scenes of which everything is known.
#include "common/choice.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numeric>
#include <random>

using namespace rt;

namespace {

/// A scene in which the errors and costs of all looks follow from a few numbers.
struct MadeUp {
    Demands demands;
    double penumbra = 0;  ///< the share of the pixels in one
    double mirror = 0;    ///< the share of the pixels that show one
    double ray_cost = 1e-7;
    double shadow_ray_cost = 1e-7;
    double list_cost = 1;       ///< in units of ray_cost
    double hierarchy_cost = 1;  ///< as well
    double reflection = 200;    ///< 8-bit steps, halved by each bounce
    std::size_t asked = 0;      ///< pixels
    double spent = 0;           ///< seconds
    std::size_t pays_from = 0;
};

constexpr double one_ray_error = 80;  ///< 8-bit steps, of a pixel in a penumbra

/// As stage 11's: n rays leave n^(−3/4) of the error of one.
double rays_for(double error) {
    return std::pow(one_ray_error / error, 4.0 / 3);
}

double error_of(const Look& look) {
    return look.shadow_error > 0 ? std::min(look.shadow_error, one_ray_error * std::pow(8, -0.75))
                                 : one_ray_error * std::pow(look.shadow_samples, -0.75);
}

/// Seconds of a pixel.
double cost_of(const MadeUp& model, const Look& look) {
    double cost = model.ray_cost;
    cost *= model.demands.most_alike >= model.pays_from ? model.hierarchy_cost : model.list_cost;
    if (model.demands.sized_lights) cost += model.shadow_ray_cost * rays_for(error_of(look));
    if (model.demands.mirrors) cost *= 1 + model.mirror * (2 - std::pow(0.5, look.depth));
    return cost;
}

class Known : public Trials {
public:
    explicit Known(MadeUp& model) : model_(model) {
        model_.pays_from = model.demands.hierarchy_from;
    }

    [[nodiscard]] Resolution resolution() const override { return {.width = 640, .height = 480}; }
    [[nodiscard]] Demands demands() const override { return model_.demands; }
    void arrange(std::size_t pays_from) override { model_.pays_from = pays_from; }

    [[nodiscard]] Shot shot(const Look& look, const ShotSettings& settings) const override {
        if (*settings.stop) return {};
        Shot shot{.seconds = cost_of(model_, look)};
        std::mt19937_64 random(unsigned(settings.round) + 1);
        std::normal_distribution<double> normal;
        for (std::size_t i = 0; i < settings.pixels; ++i) {
            double shade = 100;
            const double place = std::fmod(0.618033988749895 * double(i), 1);
            if (place < model_.penumbra) shade += error_of(look) * normal(random);
            if (place < model_.mirror && model_.demands.mirrors)
                shade -= model_.reflection * std::pow(0.5, look.depth);
            shot.shades.push_back({shade, shade, shade});
        }
        model_.asked += settings.pixels;
        model_.spent += double(settings.pixels) * shot.seconds;
        return shot;
    }

private:
    MadeUp& model_;
};

constexpr std::atomic<bool> going_on = false;

Choice chosen(MadeUp& model, const Aim& aim, const OpenFloat& open_float = {}) {
    Known known(model);
    auto choice = choose(known, open_float, aim, Clock::now(), going_on);
    REQUIRE(choice);
    for (const std::string& reason : choice->reasons) UNSCOPED_INFO(reason);
    return std::move(*choice);
}

/// The share of all pixels that are off by more than the tolerance.
double beyond(const MadeUp& model, double error, double allowed) {
    return model.penumbra * std::erfc(allowed / error / std::sqrt(2));
}

MadeUp plain() {
    return {.demands = {.extent = 10, .feature = 1, .hierarchy_from = 8, .unit_roundoff = 1e-16}};
}

MadeUp soft(double penumbra) {
    MadeUp model = plain();
    model.demands.sized_lights = true;
    model.penumbra = penumbra;
    return model;
}

}  // namespace

TEST_CASE("a tolerance is kept by 99 of 100 pixels, at the least cost within a quarter") {
    std::vector<double> costs;  // in units of the least
    for (const double penumbra : {0.1, 0.3, 1.0})
        for (const double allowed : {0.5, 1.0, 2.0, 8.0}) {
            MadeUp model = soft(penumbra);
            const Look look = chosen(model, {.tolerance = allowed}).expected.look;
            INFO(penumbra << " of the pixels in a penumbra, tolerance " << allowed);
            CHECK(beyond(model, error_of(look), allowed) <= 0.01);
            double cheapest = cost_of(model, look);
            for (double error = 40; error > 0.01; error *= 0.99)
                if (beyond(model, error, allowed) <= 0.01) {
                    cheapest = cost_of(model, {.shadow_samples = 1, .shadow_error = error});
                    break;
                }
            costs.push_back(cost_of(model, look) / cheapest);
            CHECK(costs.back() <= 1.4);                                     // a trial's luck
            CHECK(model.spent <= 0.12 * 640 * 480 * cost_of(model, look));  // on trials
        }
    CHECK(std::reduce(costs.begin(), costs.end()) / double(costs.size()) <= 1.25);
}

TEST_CASE("where fewer than one pixel in a hundred is in a penumbra, one ray is enough") {
    MadeUp model = soft(0.002);
    const Look look = chosen(model, {.tolerance = 1}).expected.look;
    CHECK(look.shadow_samples == 1);
    CHECK(look.shadow_error == 0);
}

TEST_CASE("mirrors are followed until no more than the tolerance is missing") {
    for (const double allowed : {0.5, 2.0, 7.0, 30.0}) {
        MadeUp model = plain();
        model.demands.mirrors = true;
        model.mirror = 0.3;
        const int depth = chosen(model, {.tolerance = allowed}).expected.look.depth;
        INFO("tolerance " << allowed << ", depth " << depth);
        CHECK(model.reflection * std::pow(0.5, depth) <= allowed);
        // The depths tried are no further apart than this.
        CHECK(model.reflection * std::pow(0.5, 0.7 * depth - 1) > allowed);
    }
    MadeUp model = plain();
    model.demands.mirrors = true;
    model.mirror = 0.001;
    CHECK(chosen(model, {.tolerance = 1}).expected.look.depth == 0);
    CHECK(chosen(model, {.look = {.depth = 5}, .tolerance = 1, .given = {.depth = true}})
              .expected.look.depth == 5);
}

TEST_CASE("what a scene does not require is not tried") {
    MadeUp model = plain();
    const Choice choice = chosen(model, {.look = {.depth = 8}, .tolerance = 1});
    CHECK(choice.expected.look.depth == 8);
    CHECK(choice.expected.look.shadow_samples == Look().shadow_samples);
    CHECK(model.asked == 640 * 480 / 128);  // for the time that it will take
    CHECK(model.pays_from == 8);
}

TEST_CASE("a hierarchy is built where it is cheaper") {
    for (const std::size_t count : {2, 7, 8, 64})
        for (const double list : {0.5, 0.99, 1.01, 2.0}) {
            MadeUp model = plain();
            model.demands.most_alike = count;
            model.list_cost = list;
            (void)chosen(model, {.tolerance = 1});
            const bool usual = count >= 8;
            INFO(count << " shapes, a list takes " << list << " times as long");
            // Within the clock's noise it is as usual.
            CHECK((count >= model.pays_from) == (list == 0.5 ? false : list == 2 || usual));
        }
    MadeUp model = plain();
    model.demands.most_alike = 1000;
    model.list_cost = 0.5;
    (void)chosen(model, {.tolerance = 1});
    CHECK(model.pays_from == 8);  // nobody tried a list
}

TEST_CASE("float is taken where it does as well, and is faster") {
    for (const double feature : {1.0, 1e-3})
        for (const double cost : {0.5, 1.0}) {
            MadeUp model = plain();
            model.demands.feature = feature;
            MadeUp in_float = model;
            in_float.ray_cost *= cost;
            bool opened = false;
            Known known(in_float);
            const OpenFloat open_float = [&]() -> Trials& {
                opened = true;
                return known;
            };
            const Choice choice = chosen(model, {.tolerance = 1}, open_float);
            INFO("sizes from " << feature << ", float costs " << cost);
            // 255 · 8 u · 10 / feature: 1e-3 of a step, or 1.2.
            CHECK(choice.in_float == (feature == 1 && cost == 0.5));
            CHECK(opened == (feature == 1));
        }
    MadeUp model = plain();
    CHECK_FALSE(chosen(model, {.tolerance = 1}).in_float);  // a program that cannot open it
}

TEST_CASE("a time is filled by shadow samples, and depth makes room for it") {
    for (const double seconds : {0.5, 1.0, 5.0}) {
        MadeUp model = soft(0.5);
        const Choice choice = chosen(model, {.time = seconds});
        CHECK(choice.expected.seconds == Approx(seconds).epsilon(0.02));
        CHECK(640 * 480 * cost_of(model, choice.expected.look) == Approx(seconds).epsilon(0.1));
        CHECK(choice.pace != nullptr);
    }
    MadeUp model = plain();
    model.demands.mirrors = true;
    model.mirror = 1;
    model.ray_cost = 1e-6;  // 0.61 s without a reflection, 0.77 with one, 0.92 with all
    const Choice choice = chosen(model, {.time = 0.8});
    CHECK(choice.expected.seconds <= 0.8);
    CHECK(choice.expected.look.depth == 1);
}

TEST_CASE("with a tolerance and a time, the time is the limit of the tolerance") {
    MadeUp model = soft(0.5);
    const double enough = chosen(model, {.tolerance = 2}).expected.seconds;
    CHECK(chosen(model, {.tolerance = 2, .time = 10 * enough}).expected.seconds == Approx(enough));
    CHECK(chosen(model, {.tolerance = 2, .time = enough / 3}).expected.seconds ==
          Approx(enough / 3).epsilon(0.02));
}

TEST_CASE("trials can be stopped") {
    MadeUp model = soft(0.5);
    const std::atomic<bool> stopped = true;
    Known known(model);
    CHECK_FALSE(choose(known, {}, {.tolerance = 1}, Clock::now(), stopped));
}

TEST_CASE("a pace takes its time on a machine that is slower or faster than expected") {
    Ladder ladder;
    for (const double error : {16, 8, 4, 2, 1})
        ladder.add({.look = {.shadow_error = error}, .seconds = 16 / error, .error = error});
    constexpr int rows = 480;
    for (const double slower : {0.4, 1.0, 3.0})
        for (const double wanted : {4.0, 12.0}) {
            const Clock::time_point start{};
            const auto at = [&](double seconds) {
                return start + std::chrono::duration_cast<Clock::duration>(
                                   std::chrono::duration<double>(seconds));
            };
            Pace pace(ladder, rows, at(wanted), start);
            double now = 0;
            for (int row = 0; row < rows; ++row) {
                // A row costs what the golden ratio gives it, 0 to 2 times the mean.
                const double uneven = 2 * std::fmod(0.618033988749895 * row, 1.0);
                now += uneven * slower * 16 / pace.next(at(now)).shadow_error / rows;
            }
            INFO(slower << " times slower, " << wanted << " s");
            const double least = slower;      // all rows by the first look
            const double most = 16 * slower;  // by the last
            CHECK(now == Approx(std::clamp(wanted, least, most)).epsilon(0.05));
        }
}
