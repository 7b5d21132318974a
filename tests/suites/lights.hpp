// Questions about lights, for `trace` of stage 9 or 10 and all later ones: scenes of one pixel.
//
// The ray meets the white wall at 0,0,-4. A light at 3,0,0 is at a cosine of 0.8 there, 5 away.
#pragma once

#include "tests/suites/kinds.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace rt {

/// The terms of all lights add up, and the ambient term counts once, from an eye anywhere.
inline Verdict terms_add_up() {
    const std::string wall = "pl 0,0,-4 0,0,1 255,255,255\n";
    const std::string shining = "pl 0,0,-4 0,0,1 0,0,255 spec:0.5 shin:1\n";
    const std::string ambient = "A 0.2 255,255,255\n";
    const std::string light = "L 0,0,0 0.4 255,255,255\n";
    std::string twenty;
    for (int i = 0; i < 20; ++i) twenty += "L 0,0,0 0.02 255,255,255\n";
    Verdict all;
    keep_first(all, shows(ambient + wall, {51, 51, 51}));
    keep_first(all, shows(ambient + light + wall, {153, 153, 153}));
    keep_first(all, shows(twenty + wall, {102, 102, 102}));
    keep_first(all, shows("L 0,0,0 0.4 255,0,0\nL 0,0,0 0.2 255,0,0\n" + shining, {76, 0, 0}));
    // The eye is at 0.8 of the direction of reflection.
    keep_first(all, shows("C 6,0,0 0,0,-1 60\nL 9,0,0 0.5 255,255,255\n" + shining, {51, 51, 153}));
    return all;
}

/// The option --term selects a term of the sum.
inline Verdict term_is_selected() {
    const std::string scene =
        "A 0.2 255,255,255\nL 0,0,0 0.4 255,255,255\npl 0,0,-4 0,0,1 0,0,255 spec:0.5 shin:10\n";
    Verdict all;
    keep_first(all, shows(scene, {0, 0, 51}, {.term = PhongTerm::ambient}));
    keep_first(all, shows(scene, {0, 0, 102}, {.term = PhongTerm::diffuse}));
    keep_first(all, shows(scene, {51, 51, 51}, {.term = PhongTerm::specular}));
    return all;
}

/// A shape of each kind of stages 3 to 8, halfway to the light on the right.
inline const std::array<std::string, 6> halfway_shapes = {
    "sp 1.5,0,-2 0.2 9,9,9\n",
    "pl 1.5,0,0 1,0,0 9,9,9\n",
    "tr 1.5,-1,-2.5 1.5,-1,-1.5 1.5,1,-2 9,9,9\n",
    "sq 1.5,0,-2 0.6,0,0.8 0.3 9,9,9\n",
    "cy 1.5,0,-2 0,1,0 0.2 2 9,9,9\n",
    "co 1.5,1,-2 0,-1,0 0.4 2 9,9,9\n",
};

/// Each kind of shape takes the light on the right away, and not the one on the left. `option`
/// follows each light.
inline Verdict every_kind_casts_a_shadow(const std::string& option) {
    const std::string lights =
        "L 3,0,0 0.5 255,0,0" + option + "\nL -3,0,0 0.5 0,255,0" + option + "\n";
    const std::string wall = "pl 0,0,-4 0,0,1 255,255,255\n";
    Verdict all;
    for (const std::string& shape : halfway_shapes) {
        keep_first(all, shows(lights + wall + shape, {0, 102, 0}));
        keep_first(all, shows(lights + shape + wall, {0, 102, 0}));
    }
    return all;
}

/// A ball casts a shadow from a hundred-thousandth of the way to the light, and almost as close to
/// the light: no constant cuts off either end of the way.
inline Verdict shadows_at_both_ends() {
    const std::string scene = "L 3,0,0 0.5 255,0,0\npl 0,0,-4 0,0,1 255,255,255\n";
    Verdict all;
    keep_first(all, shows(scene + "sp 0.00003,0,-3.99996 0.00004 9,9,9\n", {0, 0, 0}));
    keep_first(all, shows(scene + "sp 2.99988,0,-0.00016 0.00016 9,9,9\n", {0, 0, 0}));
    return all;
}

/// A lamp that lies in a ceiling, at 5° or more, is not shadowed by it.
inline Verdict ceilings_leave_their_lamp() {
    return for_all(
        [](Random& random) {
            const auto part = [&] { return random.below(1000) * 0.001; };
            const auto row = [](double x, double y, double z) {
                return std::to_string(x) + "," + std::to_string(y) + "," + std::to_string(z);
            };
            const double x = 3 + part();
            const double y = part();
            const double z = part();
            const double right = random.below(10);
            const double up = random.below(10);
            const double back = 1 + random.below(9);
            const std::string ceiling =
                "pl " + row(x + back, y, z - right) + " " + row(right, up, back) + " 9,9,9\n";
            const auto level = std::uint8_t(127.5 * (z + 4) / std::hypot(x, y, z + 4) + 0.5);
            return shows("L " + row(x, y, z) + " 0.5 255,255,255\n" + ceiling +
                             "pl 0,0,-4 0,0,1 255,255,255\n",
                         {level, level, level});
        },
        20);
}

/// A single sample of an area light is seen or not, and --shadow-samples is their number. The card
/// hides most of the light.
inline Verdict samples_are_whole() {
    const std::string scene =
        "L 3,0,0 0.5 255,0,0 radius:0.3\npl 0,0,-4 0,0,1 255,255,255\n"
        "sq 1.5,0.94,-2 0.6,0,0.8 2 9,9,9\n";
    Verdict all;
    for (const int samples : {1, 2, 3, 5, 9}) {
        const RenderSettings settings{.shadow_samples = samples};
        const Rgb got = seen(scene, settings);
        const double reached = std::round(double(got[0]) / 102 * samples);
        const double level = std::min(reached, double(samples)) * 102 / samples;
        keep_first(all, shows(scene, {std::uint8_t(std::lround(level)), 0, 0}, settings));
    }
    return all;
}

/// Twenty lights in one place are half hidden, and get one sample each. If each light has samples
/// of its own, the point sees some of them: all or none have a probability of 2^-19.
inline Verdict lights_have_their_own_samples() {
    std::string scene = "pl 0,0,-4 0,0,1 255,255,255\nsq 1.5,1,-2 0.6,0,0.8 2 9,9,9\n";
    for (int i = 0; i < 20; ++i) scene += "L 3,0,0 0.05 255,0,0 radius:0.3\n";
    const RenderSettings one{.shadow_samples = 1};
    return shows(scene, {102, 0, 0}, one, 97);
}

}  // namespace rt
