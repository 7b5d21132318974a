// Questions about lights, for `trace` of stage 9 or 10 and all later ones: scenes of one pixel.
//
// The ray hits the white wall at 0,0,-4. A light at 3,0,0 is at a cosine of 0.8 there, 5 away.
#pragma once

#include "tests/suites/kinds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace rt {

/// A number with two decimals, for sentences.
inline std::string decimal(Real number) {
    std::array<char, 32> buffer;
    std::snprintf(buffer.data(), buffer.size(), "%.2f", double(number));
    return buffer.data();
}

/// The terms of all lights add up, and the ambient term counts once, from an eye anywhere.
inline Verdict terms_add_up() {
    const std::string wall = "pl 0,0,-4 0,0,1 255,255,255\n";
    const std::string shining = "pl 0,0,-4 0,0,1 0,0,255 spec:0.5 shin:1\n";
    const std::string ambient = "A 0.2 255,255,255\n";
    const std::string light = "L 0,0,0 0.4 255,255,255\n";
    const std::string half_light = "L 0,0,0 0.2 255,255,255\n";
    std::string thousand;  // each of which alone is less than half of one level of 255
    for (int i = 0; i < 1000; ++i) thousand += "L 0,0,0 0.0004 255,255,255\n";
    Verdict all;
    keep_first(all, shows(ambient + wall, {51, 51, 51}));
    keep_first(all, shows_exactly(ambient + light + wall, Color(Real(0.6))));
    keep_first(all, shows(ambient + half_light + half_light + wall, {153, 153, 153}));
    keep_first(all, shows(ambient + thousand + wall, {153, 153, 153}));
    // A light behind the wall adds nothing, and those after it count.
    keep_first(all, shows("L 0,0,-9 1 255,255,255\n" + light + wall, {102, 102, 102}));
    keep_first(all, shows("L 0,0,0 0.4 255,0,0\nL 0,0,0 0.2 255,0,0\n" + shining, {76, 0, 0}));
    // The eye is at 0.8 of the direction of reflection.
    keep_first(all, shows("C 6,0,0 0,0,-1 60\nL 9,0,0 0.5 255,255,255\n" + shining, {51, 51, 153}));
    return all;
}

/// Each kind of shape is lit on the side of the eye, whichever its normal points to.
inline Verdict every_kind_is_lit_from_either_side(int stage) {
    const std::string light = "L 0,0,0 0.4 255,255,255\n";
    Verdict all;
    for (const Kind& kind : kinds_until(stage)) {
        const auto level = std::uint8_t(102 * kind.torch + 0.5);
        for (const Kind::Line line : {kind.line, kind.other_side})
            keep_first(all, shows(light + line(5, "255,255,255"), {level, level, level}));
    }
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

/// A shape of each kind of stages 3 to 8, in the order of all_kinds, halfway to the light on the
/// right.
inline const std::array<std::string, 6> halfway_shapes = {
    "sp 1.5,0,-2 0.2 9,9,9\n",
    "pl 1.5,0,0 1,0,0 9,9,9\n",
    "tr 1.5,-1,-2.5 1.5,-1,-1.5 1.5,1,-2 9,9,9\n",
    "sq 1.5,0,-2 0.6,0,0.8 0.3 9,9,9\n",
    "cy 1.5,0,-2 0,1,0 0.2 2 9,9,9\n",
    "co 1.5,1,-2 0,-1,0 0.4 2 9,9,9\n",
};

/// The lights of a shape at 0,0,-4 with all three terms, if its material has spec:0.5 shin:1: the
/// blue ambient light, a red light on the right, which the halfway shapes hide, and a green one on
/// the left, whose highlight is at 0.8 of the direction of reflection.
inline const std::string all_terms = "A 0.2 0,0,255\nL 3,0,0 0.5 255,0,0\nL -3,0,0 0.5 0,255,0\n";

/// The term that the option --term selects has its shadows.
inline Verdict term_has_shadows() {
    const std::string scene =
        all_terms + "pl 0,0,-4 0,0,1 255,255,255 spec:0.5 shin:1\n" + halfway_shapes[0];
    Verdict all;
    keep_first(all, shows(scene, {0, 0, 51}, {.term = PhongTerm::ambient}));
    keep_first(all, shows(scene, {0, 102, 0}, {.term = PhongTerm::diffuse}));
    keep_first(all, shows(scene, {0, 51, 0}, {.term = PhongTerm::specular}));
    return all;
}

/// This many shapes of the kind behind the wall, where they block no light.
inline std::string behind_the_wall(const Kind& kind, int count) {
    std::string lines;
    for (int i = 0; i < count; ++i) lines += kind.line(9 + 3 * i, "9,9,9");
    return lines;
}

/// The shape blocks a light as the first, one in the middle and the last of a list of its kind,
/// however long the list is.
inline Verdict blocks_at_any_place(const std::string& scene, const Kind& kind,
                                   const std::string& shape, Rgb expected) {
    const std::string one = behind_the_wall(kind, 1);
    Verdict all;
    keep_first(all, shows(scene + one + shape, expected));
    keep_first(all, shows(scene + shape + one, expected));
    keep_first(all, shows(scene + one + shape + one, expected));
    keep_first(all, shows(scene + behind_the_wall(kind, 1100) + shape, expected));
    return all;
}

/// Each kind of shape takes the light on the right away, and not the one on the left. `option`
/// follows each light.
inline Verdict every_kind_casts_a_shadow(const std::string& option) {
    const std::string lights =
        "L 3,0,0 0.5 255,0,0" + option + "\nL -3,0,0 0.5 0,255,0" + option + "\n";
    const std::string wall = "pl 0,0,-4 0,0,1 255,255,255\n";
    Verdict all;
    for (std::size_t i = 0; i < halfway_shapes.size(); ++i) {
        const std::string& shape = halfway_shapes[i];
        keep_first(all, shows(lights + wall + shape, {0, 102, 0}));
        keep_first(all, shows(lights + shape + wall, {0, 102, 0}));
        keep_first(all, blocks_at_any_place(lights + wall, all_kinds[i], shape, {0, 102, 0}));
    }
    return all;
}

/// A card at any share of the way hides a light of the radius 0.3, and a ball behind it does not.
inline Verdict area_shadows_end_at_the_light() {
    const std::string scene = "L 3,0,0 0.5 255,0,0 radius:0.3\npl 0,0,-4 0,0,1 255,255,255\n";
    Verdict all;
    for (const std::string card :
         {"2.79,0,-0.28 0.6,0,0.8 2", "2.4,0,-0.8 0.6,0,0.8 1", "0.6,0,-3.2 0.6,0,0.8 1",
          "0.24,0,-3.68 0.6,0,0.8 0.4", "0.0003,0,-3.9996 0.6,0,0.8 0.0005"})
        keep_first(all, shows(scene + "sq " + card + " 9,9,9\n", {0, 0, 0}));
    keep_first(all, shows(scene + "sp 6,0,4 2 9,9,9\n", {102, 0, 0}));
    return all;
}

/// A ball casts a shadow from a hundred-thousandth of the way to the light, and almost as close to
/// the light: no constant cuts off either end of the way.
inline Verdict shadows_at_both_ends() {
    const std::string scene = "L 3,0,0 0.5 255,0,0\npl 0,0,-4 0,0,1 255,255,255\n";
    Verdict all = area_shadows_end_at_the_light();
    keep_first(all, shows(scene + "sp 0.00003,0,-3.99996 0.00004 9,9,9\n", {0, 0, 0}));
    keep_first(all, shows(scene + "sp 2.99988,0,-0.00016 0.00016 9,9,9\n", {0, 0, 0}));
    if (sizeof(Real) > sizeof(float))  // and from a ten-millionth
        keep_first(all, shows(scene + "sp 0.0000003,0,-3.9999996 0.0000004 9,9,9\n", {0, 0, 0}));
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

/// The light on the right, of radius 0.3, and a card halfway to it, which hides three quarters of
/// it: its edge is at 0.4 of the radius, as seen from the wall.
inline const std::string red_light_and_wall =
    "L 3,0,0 0.5 255,0,0 radius:0.3\npl 0,0,-4 0,0,1 255,255,255\n";
inline const std::string three_quarters_hidden = "sq 1.5,0.94,-2 0.6,0,0.8 2 9,9,9\n";

/// The share of that light that the scene's only pixel shows. Its whole light is 0.4.
inline Real share_seen(const std::string& scene, int samples) {
    return seen_unrounded(scene, {.shadow_samples = samples}).r / Real(0.4);
}

inline std::string share_report(const std::string& scene, int samples) {
    return pixel_report(
        "the share of an area light that reaches the surface, with "
        "--shadow-samples " +
            std::to_string(samples),
        scene);
}

/// The share is a whole number of these samples.
inline Verdict share_is_of_samples(const std::string& scene, int samples) {
    const Real reached = share_seen(scene, samples) * Real(samples);
    // A few roundings of the light's terms, and one for each sample where they are added one by
    // one.
    const Real rounding = Real(samples) * Real(256 + samples) * epsilon;
    const Real whole = std::round(reached);
    const bool is_of_samples =
        std::abs(reached - whole) <= rounding && whole >= 0 && whole <= Real(samples);
    return verdict(is_of_samples, share_report(scene, samples) + "\n  got:      that of " +
                                      decimal(reached) +
                                      " samples\n  expected: that of a whole number of samples");
}

/// A single sample of an area light is seen or not, and --shadow-samples is their number.
inline Verdict samples_are_whole() {
    Verdict all;
    // Prime numbers: a loop with fewer samples has other shares.
    std::vector<int> counts = {1, 2, 3, 5, 97, 499, 1009};
    if (sizeof(Real) > sizeof(float)) counts.insert(counts.end(), {2003, 4099});  // float rounds
    for (const int samples : counts)
        keep_first(all, share_is_of_samples(red_light_and_wall + three_quarters_hidden, samples));
    return all;
}

/// If 1/64 of a light is seen, or hidden, some of 1024 samples differ from the others, however many
/// of the first agree: for independent points, none or four times as many have a probability of
/// 10^-6.
inline Verdict small_shares_are_seen() {
    constexpr int samples = 1024;
    Verdict all;
    // The edge is at 0.912 of the light's radius, above, below, to the left and to the right.
    const auto card = [](const std::string& center) {
        return "sq " + center + " 0.6,0,0.8 1 9,9,9\n";
    };
    const auto is_small = [&](const std::string& center, bool hidden) {
        const std::string scene = red_light_and_wall + card(center);
        const Real share = share_seen(scene, samples);
        const Real small = hidden ? share : 1 - share;
        return verdict(small > 0 && small < Real(0.0625),
                       share_report(scene, samples) + "\n  got:      " + decimal(share) +
                           "\n  expected: about " + (hidden ? "0.016" : "0.984"));
    };
    for (const std::string center :
         {"1.5,0.3632,-2", "1.5,-0.3632,-2", "1.79056,0,-2.21792", "1.20944,0,-1.78208"})
        keep_first(all, is_small(center, true));
    for (const std::string center :
         {"1.5,0.6368,-2", "1.5,-0.6368,-2", "2.00944,0,-2.38208", "0.99056,0,-1.61792"})
        keep_first(all, is_small(center, false));
    return all;
}

/// A light that is three quarters hidden shows a quarter, in a scene a hundred times smaller or
/// larger too.
inline Verdict lights_of_any_size_are_sampled() {
    const RenderSettings many{.shadow_samples = 256};
    Verdict all;
    keep_first(all, shows("L 0.03,0,0 0.5 255,0,0 radius:0.003\npl 0,0,-0.04 0,0,1 255,255,255\n"
                          "sq 0.015,0.0094,-0.02 0.6,0,0.8 0.02 9,9,9\n",
                          {26, 0, 0}, many, 10));
    keep_first(all, shows("L 300,0,0 0.5 255,0,0 radius:30\npl 0,0,-400 0,0,1 255,255,255\n"
                          "sq 150,94,-200 0.6,0,0.8 200 9,9,9\n",
                          {26, 0, 0}, many, 10));
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

/// Two pixels of the picture that are so far apart differ somewhere.
inline bool differ_at(int rows, int columns, const Image& image) {
    const auto [width, height] = image.resolution;
    for (Pixel pixel; pixel.row + rows < height; ++pixel.row)
        for (pixel.column = std::max(-columns, 0); pixel.column + std::max(columns, 0) < width;
             ++pixel.column)
            if (image[pixel] != image[{pixel.row + rows, pixel.column + columns}]) return true;
    return false;
}

/// The pattern in which the pixels repeat each other; empty if there is none.
inline std::string pattern_of(const Image& image) {
    if (!differ_at(0, 1, image) && !differ_at(1, 0, image))
        return "all pixels are equal, as if they had the same samples";
    constexpr int period = 16;
    for (int rows = 0; rows <= period; ++rows)
        for (int columns = rows == 0 ? 1 : -period; columns <= period; ++columns)
            if (!differ_at(rows, columns, image))
                return "every pixel is like the one " + std::to_string(rows) + " rows and " +
                       std::to_string(columns) + " columns further";
    const int size = image.resolution.width;
    bool differ_across = false;
    for (Pixel pixel; pixel.row < size; ++pixel.row)
        for (pixel.column = 0; pixel.column < pixel.row; ++pixel.column)
            differ_across |= image[pixel] != image[{pixel.column, pixel.row}];
    if (!differ_across) return "every pixel is like the one with its row and column exchanged";
    for (int i = 0; i < size; ++i) {
        bool differ_in_row = false;
        bool differ_in_column = false;
        for (int j = 1; j < size; ++j) {
            differ_in_row |= image[{i, j}] != image[{i, 0}];
            differ_in_column |= image[{j, i}] != image[{0, i}];
        }
        if (!differ_in_row) return "all pixels of row " + std::to_string(i) + " agree";
        if (!differ_in_column) return "all pixels of column " + std::to_string(i) + " agree";
    }
    return "";
}

/// In a picture in which all pixels see the same half of a light, with one sample each, there is no
/// pattern, and the next picture is the same. If each pixel has samples of its own, all of a row
/// agree with a probability of 2^-39.
inline Verdict pixels_have_their_own_samples() {
    constexpr int size = 40;
    return for_all(
        [](Random& random) {
            // An edge of the triangle crosses the light's center.
            const double angle = double(random.between(0, 2 * pi));
            const double c = std::cos(angle);
            const double s = std::sin(angle);
            const auto row = [](double x, double y, double z) {
                return " " + std::to_string(x) + "," + std::to_string(y) + "," + std::to_string(z);
            };
            const std::string scene = "C 0,0,0 0,0,-1 0.01\nL" + row(3 * c, 3 * s, 0) +
                                      " 0.5 255,0,0 radius:0.3\npl 0,0,-4 0,0,1 255,255,255\ntr" +
                                      row(2.3 * c, 2.3 * s, -2.6) + row(0.7 * c, 0.7 * s, -1.4) +
                                      row(1.5 * c - s, 1.5 * s + c, -2) + " 9,9,9\n";
            const auto draw = [&scene] {
                return picture_seen(scene, {.width = size, .height = size}, {.shadow_samples = 1});
            };
            const Image image = draw();
            const std::string pattern = pattern_of(image);
            const std::string question =
                pixel_report("the pixels of a picture of 40 x 40, with --shadow-samples 1", scene);
            if (!pattern.empty())
                return verdict(false, question + "\n  got:      " + pattern +
                                          "\n  expected: each pixel has samples of its own");
            return verdict(draw().pixels == image.pixels,
                           question +
                               "\n  got:      another picture, the second time"
                               "\n  expected: the same: samples depend on their seed alone");
        },
        3);
}

/// In a picture in which all pixels see a quarter of each of two lights, with 64 samples, the
/// shares of the pixels are no more uneven than 2/3 of those of independent points, √(¼ · ¾ / 64) =
/// 0.054. The first 64 points of a sequence have 0.016 or so. Every second point, if the two lights
/// divide a sequence, covers half of a light only.
inline Verdict samples_are_well_spread() {
    constexpr int size = 16;
    constexpr int samples = 64;
    const std::string scene =
        "C 0,0,0 0,0,-1 0.01\npl 0,0,-4 0,0,1 255,255,255\n"
        "L 3,0,0 1 255,0,0 radius:0.3\nsq 1.5,0.94,-2 0.6,0,0.8 2 9,9,9\n"
        "L -3,0,0 1 0,255,0 radius:0.3\nsq -1.5,0.94,-2 -0.6,0,0.8 2 9,9,9\n";
    const Image image =
        picture_seen(scene, {.width = size, .height = size}, {.shadow_samples = samples});
    Real squares = 0;
    for (const Rgb color : image.pixels)
        for (const int level : {color[0], color[1]}) {
            const Real off = Real(level) / (Real(0.8) * 255) - Real(0.25);
            squares += off * off;
        }
    const Real off = std::sqrt(squares / Real(2 * image.pixels.size()));
    return verdict(
        off < Real(0.036),
        pixel_report("the pixels of a picture of 16 x 16, with --shadow-samples 64", scene) +
            "\n  got:      shares of a quarter of a light, off by " + decimal(off) +
            "\n  expected: off by about 0.02: each pixel and light has the samples"
            "\n            spread_sample(0, seed), spread_sample(1, seed), …");
}

/// Area lights are as in stage 11: each light has the share of its own samples that reach it.
inline Verdict area_lights_are_sampled() {
    const std::string other = "L -3,0,0 0.5 0,255,0 radius:0.3\n";
    const RenderSettings many{.shadow_samples = 256};
    Verdict all;
    keep_first(all, shows(red_light_and_wall + other, {102, 102, 0}));
    keep_first(all,
               shows(red_light_and_wall + three_quarters_hidden + other, {26, 102, 0}, many, 10));
    // The eye is at 0.8 of the direction of reflection.
    keep_first(all, shows("L 3,0,0 0.5 255,255,255 radius:0.3\n"
                          "pl 0,0,-4 0,0,1 0,0,255 spec:0.5 shin:1\n" +
                              three_quarters_hidden,
                          {13, 13, 38}, many, 10));
    keep_first(all, samples_are_whole());
    keep_first(all, small_shares_are_seen());
    keep_first(all, lights_of_any_size_are_sampled());
    keep_first(all, lights_have_their_own_samples());
    keep_first(all, pixels_have_their_own_samples());
    keep_first(all, samples_are_well_spread());
    return all;
}

}  // namespace rt
