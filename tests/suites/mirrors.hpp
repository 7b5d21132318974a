// Questions about mirrors, for `trace` of stages 12 and 13: scenes of one pixel.
//
// The ray meets a mirror at 0,0,-4. A wall at z = 6, behind the eye, is what it shows.
#pragma once

#include "tests/suites/kinds.hpp"

namespace rt {

/// A mirror shows the sum of all terms, which may be brighter than white before its share is taken.
inline Verdict mirrors_show_all_terms() {
    const std::string light = "L 0,0,0 0.4 255,255,255\n";
    const std::string perfect = "pl 0,0,-4 0,0,1 255,255,255 mirror:1\n";
    const std::string black = "pl 0,0,-4 0,0,1 0,0,0 mirror:0.5\n";
    const std::string shining = "pl 0,0,6 0,0,-1 0,0,255 spec:0.5 shin:10\n";
    const std::string white = "pl 0,0,6 0,0,-1 255,255,255\n";
    Verdict all;
    keep_first(all, shows(light + perfect + shining, {51, 51, 153}));
    keep_first(all, shows("A 0.2 255,255,255\n" + light + perfect + white, {153, 153, 153}));
    keep_first(all, shows("A 1 255,255,255\n" + light + black + white, {179, 179, 179}));
    return all;
}

/// A mirror at any angle does not show itself: its only reflection is the sky.
inline Verdict mirrors_do_not_show_themselves() {
    return for_all(
        [](Random& random) {
            const auto part = [&] { return std::to_string(random.below(1000) * 0.001); };
            const std::string x = part();
            const std::string y = part();
            const std::string point = x + "," + y + ",-4." + part().substr(2);
            const std::string right = std::to_string(random.below(19) - 9);
            const std::string up = std::to_string(random.below(19) - 9);
            const std::string mirror =
                random.coin() ? "pl " + point + " " + right + "," + up + ",9"
                              : "sp " + point + " " + std::to_string(3 + random.below(4));
            return shows("sky 0,255,0 0,255,0\n" + mirror + " 255,255,255 mirror:1\n", {0, 255, 0},
                         {.depth = 1});
        },
        40);
}

/// The sky is seen in a mirror, and --depth is the largest number of reflections.
inline Verdict reflections_end() {
    const std::string two =
        "A 1 255,255,255\nsky 255,255,255 255,255,255\n"
        "pl 0,0,-4 0,0,1 0,0,255 mirror:0.5\npl 0,0,6 0,0,-1 255,0,0 mirror:0.5\n";
    Verdict all;
    keep_first(all, shows("sky 0,255,0 0,255,0\npl 0,0,-4 0,0,1 9,9,9 mirror:1\n", {0, 255, 0}));
    keep_first(all, shows(two, {0, 0, 128}, {.depth = 0}));
    keep_first(all, shows(two, {64, 0, 128}, {.depth = 1}));
    keep_first(all, shows(two, {64, 0, 159}, {.depth = 2}));
    return all;
}

}  // namespace rt
