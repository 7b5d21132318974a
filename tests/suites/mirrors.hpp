// Questions about mirrors, for `trace` of stages 12 and 13: scenes of one pixel.
//
// The ray hits a mirror at 0,0,-4. A wall at z = 6, behind the eye, is what it shows.
#pragma once

#include "tests/suites/lights.hpp"

#include <algorithm>
#include <span>
#include <string>

namespace rt {

/// A camera and this many perfect mirrors, each of which turns its ray by a right angle. After the
/// last one the ray comes from 0,0,1 along 0,0,-1, as if the usual camera had sent it.
inline std::string seen_in_mirrors(int count, const std::string& fov = "60") {
    // Back from the last mirror, the way goes in turn to the left and away from the scene.
    const auto place = [](int number) {
        return std::to_string(-2 * (number / 2)) + ",0," + std::to_string(1 + (number - 1) / 2 * 2);
    };
    const bool even = count % 2 == 0;
    std::string lines = "C " + place(count + 1) + (even ? " 0,0,-1 " : " 1,0,0 ") + fov + "\n";
    for (int number = 1; number <= count; ++number)
        lines += "sq " + place(number) +
                 (number % 2 == 0 ? " 0.70710678,0,0.70710678" : " -0.70710678,0,-0.70710678") +
                 " 0.5 255,255,255 mirror:1\n";
    return lines;
}

/// A ray that one to six mirrors have reflected has the same color as a ray of the camera: with
/// light, shadow and sky, and with the term that the option --term selects. The ray hits one of
/// the last six kinds of this stage at 0,0,-4, and one of `hiding`, as a mirror, hides the red
/// light.
inline Verdict mirrors_show_mirrors(int stage,
                                    std::span<const std::string> hiding = halfway_shapes) {
    const auto kind_of = [stage](int count) {
        return kinds_until(stage).size() - 7 + std::size_t(count);
    };
    const auto lit = [&](int count) {
        const std::size_t kind = kind_of(count);
        const std::string material = "255,255,255 spec:0.5 shin:1";
        const bool flat = 0 < kind && kind < 4;  // the other side of other kinds is all around
        std::string mirror = hiding[std::size_t(count) % hiding.size()];
        mirror.insert(mirror.size() - 1, " mirror:1");
        return seen_in_mirrors(count) + all_terms +
               (flat ? all_kinds[kind].other_side : all_kinds[kind].line)(4, material) + mirror;
    };
    Verdict all;
    for (int count = 1; count <= 6; ++count) {
        // A cone is lit at a cosine of 0.566, and its highlight is at a right angle to the ray.
        const bool is_cone = all_kinds[kind_of(count)].torch < 1;
        keep_first(all, shows(lit(count), is_cone ? Rgb{0, 72, 51} : Rgb{0, 153, 51}));
    }
    keep_first(all, shows(lit(1), {0, 51, 0}, {.term = PhongTerm::specular}));
    keep_first(all, shows(lit(2), {0, 0, 51}, {.term = PhongTerm::ambient}));
    keep_first(all, shows(lit(3), {0, 102, 0}, {.term = PhongTerm::diffuse}));
    keep_first(all, shows(seen_in_mirrors(6) + "sky 0,255,0 0,255,0\n", {0, 255, 0}));
    return all;
}

/// Each kind of shape is a mirror, from either side. A cone sends the ray up, and one around the
/// eye sends it down; all others send it back.
inline Verdict every_kind_is_a_mirror(int stage) {
    const std::string material = "255,255,255 mirror:1";
    Verdict all;
    for (const Kind& kind : kinds_until(stage)) {
        const bool back = kind.torch == 1;
        const std::string shown = back ? "sp 0,0,2 1 255,0,0\n" : "sp 0,3,-4 1 255,0,0\n";
        const std::string other = back ? shown : "sp 0,-3,-4 1 255,0,0\n";
        const std::string bright = "A 1 255,255,255\n";
        keep_first(all, shows(bright + kind.line(4, material) + shown, {255, 0, 0}));
        keep_first(all, shows(bright + kind.other_side(4, material) + other, {255, 0, 0}));
    }
    return all;
}

/// A mirror shows the sum of all terms, which may be brighter than white before its share is taken.
inline Verdict mirrors_show_all_terms() {
    const std::string light = "L 0,0,0 0.4 255,255,255\n";
    const std::string perfect = "pl 0,0,-4 0,0,1 255,255,255 mirror:1\n";
    const std::string black = "pl 0,0,-4 0,0,1 0,0,0 mirror:0.5\n";
    const std::string shining = "pl 0,0,6 0,0,-1 0,0,255 spec:0.5 shin:10\n";
    const std::string white = "pl 0,0,6 0,0,-1 255,255,255\n";
    Verdict all;
    keep_first(all, shows(light + perfect + shining, {51, 51, 153}));
    keep_first(all, shows("A 1 255,255,255\n" + light + black + white, {179, 179, 179}));
    const std::string bright = "L 0,0,0 0.8 255,255,255\n";
    keep_first(
        all, shows(bright + bright + "pl 0,0,-4 0,0,1 255,255,255 mirror:0.5\n", {204, 204, 204}));
    // A mirror's own share is lit, and in shadow, too: half of 0.6, and of 0.2, is left.
    keep_first(all, shows(all_terms + "pl 0,0,-4 0,0,1 255,255,255 spec:0.5 shin:1 mirror:0.5\n" +
                              halfway_shapes[0],
                          {0, 76, 26}));
    // The wall is a mirror of a tenth: it shows 0.9 · 1.4, and a twentieth of itself.
    const std::string mirror = "pl 0,0,6 0,0,-1 255,255,255 mirror:0.1\n";
    keep_first(all, shows("A 1 255,255,255\n" + light + black + mirror, {169, 169, 169}));
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

/// A mirror shows black, or the sky, where its ray misses everything, and so does a second mirror.
inline Verdict mirrors_show_black_or_sky() {
    const std::string bright = "A 1 255,255,255\n";
    const std::string sky = "sky 0,0,255 255,0,0\n";
    const Rgb black = {0, 0, 0};
    const Rgb level = {128, 0, 128};
    // The normals of mirrors that send the ray to the right, to the left, up and down, and back.
    const std::string up = "0,0.70710678,0.70710678";
    const std::string down = "0,-0.70710678,0.70710678";
    const auto first = [](const std::string& normal) {
        return "pl 0,0,-4 " + normal + " 255,255,255 mirror:1\n";
    };
    Verdict all;
    for (const std::string level_ray :
         {"0.70710678,0,0.70710678", "-0.70710678,0,0.70710678", "0,0,1"}) {
        keep_first(all, shows(bright + first(level_ray), black));
        keep_first(all, shows(bright + first(level_ray) + sky, level));
    }
    keep_first(all, shows(bright + first(up), black));
    keep_first(all, shows(bright + first(up) + sky, {255, 0, 0}));
    keep_first(all, shows(bright + first(down), black));
    keep_first(all, shows(bright + first(down) + sky, {0, 0, 255}));
    // The second mirror lies below, and sends the ray to each side and back: away from the first
    // mirror, not along it, where rounding would decide whether it is hit very far away.
    for (const std::string normal :
         {"-0.5,0.70710678,0.5", "0.5,0.70710678,0.5", "0,0.70710678,0.70710678"}) {
        const std::string second = "pl 0,-5,-4 " + normal + " 255,255,255 mirror:1\n";
        keep_first(all, shows(bright + first(down) + second, black));
        keep_first(all, shows(bright + first(down) + second + sky, level));
    }
    return all;
}

/// A mirror that sends the ray up shows a ball that is close to it, of any size.
inline Verdict mirrors_show_what_is_close() {
    const std::string scene =
        "A 1 255,255,255\npl 0,0,-4 0,0.70710678,0.70710678 255,255,255 mirror:1\n"
        "pl 0,9,0 0,-1,0 0,0,255\n";
    Verdict all;
    keep_first(all, shows(scene + "sp 0,0.06,-4 0.04 0,255,0\n", {0, 255, 0}));
    keep_first(all, shows(scene + "sp 0,0.0006,-4 0.0004 0,255,0\n", {0, 255, 0}));
    if (sizeof(Real) > sizeof(float))
        keep_first(all, shows(scene + "sp 0,0.0000006,-4 0.0000004 0,255,0\n", {0, 255, 0}));
    return all;
}

/// In a mirror, too, each pixel has samples of its own: a half hidden light, with one sample, is
/// seen in some of 64 pixels. All or none have a probability of 2^-63.
inline Verdict pixels_in_mirrors_have_their_own_samples() {
    const std::string scene =
        seen_in_mirrors(1, "0.01") + red_light_and_wall + "sq 1.5,1,-2 0.6,0,0.8 2 9,9,9\n";
    const Image image = picture_seen(scene, {.width = 8, .height = 8}, {.shadow_samples = 1});
    const bool differ = std::ranges::any_of(
        image.pixels, [&](const Rgb& color) { return color != image.pixels.front(); });
    return verdict(
        differ, pixel_report("the pixels of a picture of 8 x 8, with --shadow-samples 1", scene) +
                    "\n  got:      all pixels agree"
                    "\n  expected: in a mirror, too, each pixel has samples of its own");
}

/// A mirror shows soft shadows, with all samples: a quarter of a light reaches the wall in the
/// mirror, of a light behind the eye and in the last of six mirrors.
inline Verdict mirrors_show_soft_shadows() {
    const std::string in_six = seen_in_mirrors(6) + red_light_and_wall + three_quarters_hidden;
    Verdict all;
    keep_first(all, shows("pl 0,0,-4 0,0,1 255,255,255 mirror:1\npl 0,0,6 0,0,-1 255,255,255\n"
                          "L 3,0,2 0.5 255,0,0 radius:0.3\nsq 1.5,0.94,4 0.6,0,-0.8 2 9,9,9\n",
                          {26, 0, 0}, {.shadow_samples = 256}, 10));
    keep_first(all, shows(in_six, {26, 0, 0}, {.shadow_samples = 256}, 10));
    keep_first(all, share_is_of_samples(in_six, 97));
    keep_first(all, pixels_in_mirrors_have_their_own_samples());
    return all;
}

/// A reflection is black if its weight in the pixel, the product of the shares of all mirrors on
/// its way, is less than 1/512. The mirrors' own color is black, so the pixel has the weight as
/// color.
inline Verdict weak_reflections_are_black() {
    const std::string bright = "A 1 255,255,255\n";
    const auto mirror = [](const std::string& plane, const std::string& share) {
        return "pl " + plane + " 0,0,0 mirror:" + share + "\n";
    };
    const auto in_one = [&](const std::string& share, Real weight) {
        return shows_exactly(
            bright + mirror("0,0,-4 0,0,1", share) + "pl 0,0,6 0,0,-1 255,255,255\n",
            Color(weight));
    };
    // Down at the first, and at the second to the left.
    const auto in_two = [&](const std::string& first, const std::string& second, Real weight) {
        return shows_exactly(bright + mirror("0,0,-4 0,-0.70710678,0.70710678", first) +
                                 mirror("0,-5,0 -0.70710678,0.70710678,0", second) +
                                 "pl -7,0,0 1,0,0 255,255,255\n",
                             Color(weight));
    };
    Verdict all;
    keep_first(all, in_two("0.0025", "1", Real(0.0025)));
    keep_first(all, in_two("0.0015", "1", 0));
    keep_first(all, in_one("0.0025", Real(0.0025)));
    keep_first(all, in_one("0.0015", 0));
    keep_first(all, in_two("0.05", "0.05", Real(0.0025)));
    keep_first(all, in_two("0.04", "0.04", 0));
    return all;
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
    // 1/2 + 1/8 + 1/32 + … = 2/3 is blue, 1/4 + 1/16 + … = 1/3 is red.
    keep_first(all, shows(two, {85, 0, 170}, {.depth = 100}, 2));
    // Between perfect mirrors, ten apart, the ray climbs by one on each way: it hits a wall after
    // 400 reflections.
    const std::string hall =
        "A 1 255,255,255\npl 0,0,-4 0,0,1 255,255,255 mirror:1\n"
        "pl 0,0,6 0,0,-1 255,255,255 mirror:1\nC 0,0,0 0,1,-10 60\npl 0,399.9,0 0,-1,0 255,0,0\n";
    keep_first(all, shows(hall, {255, 0, 0}, {.depth = 400}));
    keep_first(all, shows(hall, {0, 0, 0}, {.depth = 399}));
    return all;
}

}  // namespace rt
