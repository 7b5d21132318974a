#include "common/tuning/choose_hierarchy.hpp"

#include "common/tuning/wording.hpp"

namespace rt {

namespace {

/// For fewer or more shapes the faster structure is known (docs/reference/accuracy.md).
constexpr std::size_t shortest_list = 16;
constexpr std::size_t longest_list = 64;

/// A gain larger than the noise of the clock.
constexpr double gain = 0.9;

}  // namespace

HierarchyChoice choose_hierarchy(TrialRunner& runner, Trials& trials, const SceneTraits& traits,
                                 const RenderSettings& settings) {
    const std::size_t count = traits.most_alike;
    const std::string shapes = std::to_string(count) + " of a kind";
    if (const auto from = runner.aim().hierarchy_from)
        return {from, "from " + std::to_string(*from) + " of a kind on, as given"};
    if (count < 2) return {{}, "none: no two shapes are of a kind"};
    if (count < shortest_list && count < traits.hierarchy_from)
        return {{}, "none: " + shapes + " are few"};
    if (count > longest_list) return {{}, "yes: " + shapes + " are too many for a list"};

    const bool is_usual = count >= traits.hierarchy_from;
    const std::size_t other = is_usual ? count + 1 : count;
    const auto has_bvh = [&trials](std::size_t from) -> const Trials& {
        trials.build_acceleration(from);
        return trials;
    };
    const std::vector<Pixel> all = runner.spread().pixels();
    const std::vector<Pixel> pixels = some_of(all, std::max<std::size_t>(all.size() / 64, 128));
    const auto [usual, unusual] = runner.in_turn(
        settings, pixels, [&]() -> const Trials& { return has_bvh(traits.hierarchy_from); },
        [&]() -> const Trials& { return has_bvh(other); });
    const bool is_better = unusual < gain * usual;
    (void)has_bvh(is_better ? other : traits.hierarchy_from);
    const std::string how_much = ": with " + shapes + " the alternative takes " +
                                 number(is_better ? usual / unusual : unusual / usual) +
                                 " times as long";
    return {is_better ? std::optional(other) : std::nullopt,
            std::string(is_usual != is_better ? "yes" : "none") + how_much};
}

}  // namespace rt
