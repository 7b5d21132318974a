// One shape of every kind, for scenes of one pixel (tests/kit/seen.hpp).
#pragma once

#include "tests/kit/for_all.hpp"
#include "tests/kit/seen.hpp"

#include <span>
#include <string>
#include <vector>

namespace rt {

/// A kind of shape in a scene, introduced by the stage of that number. The eye is at the origin and
/// looks along 0,0,-1: the ray of the pixel hits the shape at 0,0,-depth.
struct Kind {
    using Line = std::string (*)(int depth, const std::string& color);

    int stage;
    Line line;         ///< the line of a shape in front of the eye
    Line other_side;   ///< the line of one whose normal points away from the eye there
    double torch = 1;  ///< cosine between the normal there and the direction to the eye, or from it
};

inline std::string at_depth(int depth) {
    return " 0,0," + std::to_string(-depth);
}

inline std::string triangle_at(int depth, const std::string& first, const std::string& second) {
    const std::string z = std::to_string(-depth);
    return "tr " + first + z + " " + second + z + " 0,2," + z + " ";
}

inline const std::vector<Kind> all_kinds = {
    {3, [](int d, const std::string& c) { return "sp" + at_depth(d + 1) + " 2 " + c + "\n"; },
     [](int d, const std::string& c) {
         return "sp 0,0,0 " + std::to_string(2 * d) + " " + c + "\n";
     }},
    {4, [](int d, const std::string& c) { return "pl" + at_depth(d) + " 0,0,1 " + c + "\n"; },
     [](int d, const std::string& c) { return "pl" + at_depth(d) + " 0,0,-1 " + c + "\n"; }},
    {5, [](int d, const std::string& c) { return triangle_at(d, "-1,-1,", "1,-1,") + c + "\n"; },
     [](int d, const std::string& c) { return triangle_at(d, "1,-1,", "-1,-1,") + c + "\n"; }},
    {6, [](int d, const std::string& c) { return "sq" + at_depth(d) + " 0,0,1 2 " + c + "\n"; },
     [](int d, const std::string& c) { return "sq" + at_depth(d) + " 0,0,-1 2 " + c + "\n"; }},
    {7,
     [](int d, const std::string& c) { return "cy" + at_depth(d + 1) + " 1,0,0 2 2 " + c + "\n"; },
     [](int d, const std::string& c) {
         return "cy 0,0,0 1,0,0 " + std::to_string(2 * d) + " 2 " + c + "\n";
     }},
    {8,  // of radius 1 at the height of the eye, as wide as it is high; and one around the eye
     [](int d, const std::string& c) {
         return "co 0,1," + std::to_string(-d - 1) + " 0,-1,0 4 2 " + c + "\n";
     },
     [](int d, const std::string& c) {
         return "co 0," + std::to_string(d) + ",0 0,-1,0 " + std::to_string(4 * d) + " " +
                std::to_string(2 * d) + " " + c + "\n";
     },
     0.70710678118654752},
    {13,
     [](int d, const std::string& c) {
         return "box" + at_depth(d + 1) + " 0,0,1 2,2,2 " + c + "\n";
     },
     [](int d, const std::string& c) {
         const std::string side = std::to_string(2 * d);
         return "box 0,0,0 0,0,1 " + side + "," + side + "," + side + " " + c + "\n";
     }},
    {13,
     [](int d, const std::string& c) {
         return "mesh ../tests/suites/step13_meshes/wall.off" + at_depth(d) + " 10 " + c + "\n";
     },
     [](int d, const std::string& c) {
         return "mesh ../tests/suites/step13_meshes/wall.off" + at_depth(d) + " 10 " + c +
                " dir:0,0,-1\n";
     }},
};

/// The pixel has the color, of 1, to a few roundings: shows allows 1 of 255.
inline Verdict shows_exactly(const std::string& scene, Color expected) {
    return gives(pixel_report("the color of the only pixel, of 1", scene), seen_unrounded(scene),
                 expected);
}

/// The kinds of this stage and of earlier ones.
inline std::span<const Kind> kinds_until(int stage) {
    std::size_t count = 0;
    while (count < all_kinds.size() && all_kinds[count].stage <= stage) ++count;
    return {all_kinds.data(), count};
}

inline Rgb draw_color(Random& random) {
    const auto draw = [&] { return std::uint8_t(random.below(256)); };
    return {draw(), draw(), draw()};
}

/// The color times a factor of each channel.
inline Rgb scaled(Rgb color, Color factor) {
    for (glm::length_t i = 0; i < 3; ++i)
        color[std::size_t(i)] = std::uint8_t(Real(color[std::size_t(i)]) * factor[i] + Real(0.5));
    return color;
}

/// The closest of some shapes behind each other is seen, of random kinds, distances and colors, and
/// in a random order.
inline Verdict closest_of_random_shapes_is_seen(int stage, const std::string& head, bool torch) {
    return for_all(
        [&](Random& random) {
            std::string lines;
            Rgb expected{};
            int depth = 1;
            for (int count = 1 + random.below(4); count > 0; --count) {
                const auto kinds = kinds_until(stage);
                const Kind& kind = kinds[std::size_t(random.below(int(kinds.size())))];
                const Rgb color = draw_color(random);
                depth += 3 + random.below(6);
                const std::string line = kind.line(depth, scene_color(color));
                if (lines.empty()) expected = scaled(color, Color(torch ? Real(kind.torch) : 1));
                lines = random.coin() ? lines + line : line + lines;
            }
            return shows(head + lines, expected);
        },
        40);
}

/// Two spheres almost coincide, and the closer one is seen: t is not rounded to float. Only in
/// double, because in float they coincide.
inline Verdict almost_equal_t_differ(const std::string& head) {
    Verdict all;
    if (sizeof(Real) == sizeof(float)) return all;
    const std::string near = "sp 0,0,-5 2 255,0,0\n";
    const std::string far = "sp 0,0,-5.000000001 2 0,0,255\n";
    keep_first(all, shows(head + near + far, {255, 0, 0}));
    keep_first(all, shows(head + far + near, {255, 0, 0}));
    return all;
}

/// A sphere and a plane are seen from any distance: no constant ends the search, at either end. The
/// sphere's squares, and the distance of the plane, are in the range of float.
inline Verdict all_distances_are_seen(const std::string& head) {
    const auto zeros = [](int count) { return std::string(std::size_t(count), '0'); };
    Verdict all;
    for (const std::string& shape :
         {"sp 0,0,-3" + zeros(17) + " 2" + zeros(17), "pl 0,0,-1" + zeros(36) + " 0,0,1",
          std::string("sp 0,0,-0.0000000006 0.0000000002"),
          std::string("pl 0,0,-0.0000000005 0,0,1")})
        keep_first(all, shows(head + shape + " 255,0,0\n", {255, 0, 0}));
    return all;
}

/// A one-sided square is seen from its front alone, where it hides what is behind it.
inline Verdict one_sided_squares_have_a_front(const std::string& head) {
    const std::string behind = "pl 0,0,-9 0,0,1 0,0,255\n";
    Verdict all;
    keep_first(all, shows(head + "sq 0,0,-5 0,0,1 2 255,0,0 sides:1\n" + behind, {255, 0, 0}));
    keep_first(all, shows(head + "sq 0,0,-5 0,0,-1 2 255,0,0 sides:1\n" + behind, {0, 0, 255}));
    return all;
}

/// The closest of a long list of one kind is seen, whether it is the first or the last in the file.
inline Verdict closest_of_a_long_list_is_seen(int stage, const std::string& head, bool torch) {
    constexpr int count = 1100;
    Verdict all;
    for (const Kind& kind : kinds_until(stage)) {
        const std::string closest = kind.line(4, "255,0,0");
        std::string others;
        for (int i = 1; i < count; ++i) others += kind.line(4 + 3 * i, "0,0,255");
        const auto light = std::uint8_t(255 * (torch ? kind.torch : 1) + 0.5);
        keep_first(all, shows(head + closest + others, {light, 0, 0}));
        keep_first(all, shows(head + others + closest, {light, 0, 0}));
    }
    return all;
}

/// A scene has the same color when it is computed again after other scenes: `trace` must store
/// nothing between rays.
inline Verdict colors_do_not_depend_on_order(int stage, const std::string& head) {
    return for_all(
        [&](Random& random) {
            const auto kinds = kinds_until(stage);
            std::vector<std::string> scenes;
            std::vector<Color> colors;
            for (int i = 0; i < 3; ++i) {
                const Kind& kind = kinds[std::size_t(random.below(int(kinds.size())))];
                scenes.push_back(head +
                                 kind.line(4 + random.below(6), scene_color(draw_color(random))));
                colors.push_back(seen_unrounded(scenes.back()));
            }
            for (std::size_t i = scenes.size(); i-- > 0;) {
                const Color again = seen_unrounded(scenes[i]);
                if (again == colors[i]) continue;
                return verdict(false, pixel_report("the color of the only pixel, asked again after "
                                                   "other scenes",
                                                   scenes[i]) +
                                          "\n  got:      " + text(again) + "\n  expected: " +
                                          text(colors[i]) + ", the same as before");
            }
            return Verdict{};
        },
        5);
}

/// Each kind of shape hides each other kind that is farther away, whichever is first in the file.
/// `head` has the lights; `torch` is true if a torch lights the scene.
inline Verdict nearest_of_each_pair_is_seen(int stage, const std::string& head, bool torch) {
    Verdict all;
    for (const Kind& front : kinds_until(stage)) {
        const auto light = std::uint8_t(255 * (torch ? front.torch : 1) + 0.5);
        for (const Kind& back : kinds_until(stage)) {
            const std::string near = front.line(4, "255,0,0");
            const std::string far = back.line(9, "0,0,255");
            for (const std::string& lines : {near + far, far + near})
                keep_first(all, shows(head + lines, {light, 0, 0}));
        }
    }
    keep_first(all, colors_do_not_depend_on_order(stage, head));
    keep_first(all, closest_of_random_shapes_is_seen(stage, head, torch));
    keep_first(all, closest_of_a_long_list_is_seen(stage, head, torch));
    keep_first(all, almost_equal_t_differ(head));
    keep_first(all, all_distances_are_seen(head));
    if (stage >= 6) keep_first(all, one_sided_squares_have_a_front(head));
    return all;
}

/// Each kind of shape is seen, at its brightness, by an eye that looks along 0,0,1.
inline Verdict all_are_seen_from_the_other_side(int stage) {
    Verdict all;
    for (const Kind& kind : kinds_until(stage))
        keep_first(all, shows_exactly("C 0,0,0 0,0,1 60\n" + kind.line(-5, "0,255,0"),
                                      {0, Real(kind.torch), 0}));
    return all;
}

/// Without a hit the pixel is black, or has the color of the scene's sky in the ray's direction,
/// and beside a shape that stands aside too. A color below 0 is black: rays have all directions.
inline Verdict nothing_is_black_or_sky() {
    const std::string sky = "sky 0,0,255 255,0,0\n";
    Verdict all;
    for (const std::string direction : {"0,0,-1", "0,0,1", "1,0,0", "-1,0,0", "0,1,0", "0,-1,0"}) {
        const std::string camera = "C 0,0,0 " + direction + " 60\n";
        keep_first(all, shows(camera, {0, 0, 0}));
        keep_first(all, shows(camera + "sp 30,30,30 2 255,0,0\n", {0, 0, 0}));
        keep_first(all, shows("A 1 255,255,255\n" + camera, {0, 0, 0}));
    }
    keep_first(all, shows(sky, {128, 0, 128}));
    keep_first(all, shows(sky + "C 0,0,0 0,0.6,-0.8 60\n", {204, 0, 51}));
    keep_first(all, shows(sky + "C 0,0,0 0,-0.6,-0.8 60\n", {51, 0, 204}));
    keep_first(all, shows(sky + "C 0,0,0 0,-1,0 60\nsp 3,0,-5 2 0,255,0\n", {0, 0, 255}));
    return all;
}

/// The option --shade normal shows |x|, |y|, |z| of the normal, from either side of every kind of
/// shape. Without a hit the pixel is the sky's.
inline Verdict shade_normal_shows_the_normal(int stage) {
    const RenderSettings normals{.shading = Shading::normal};
    Verdict all;
    keep_first(all, shows("sp 0,3,-10 10 255,0,0\n", {0, 153, 204}, normals));
    keep_first(all, shows("sp 0,-6,0 20 255,0,0\n", {0, 153, 204}, normals));
    for (const Kind& kind : kinds_until(stage)) {
        // The normals that do not face the eye lean by 45°, up or down.
        const Rgb expected = kind.torch < 1 ? Rgb{0, 180, 180} : Rgb{0, 0, 255};
        keep_first(all, shows(kind.line(5, "255,0,0"), expected, normals));
        keep_first(all, shows(kind.other_side(5, "255,0,0"), expected, normals));
    }
    keep_first(all, shows("sky 0,0,255 255,0,0\nsp 3,0,-5 2 0,255,0\n", {128, 0, 128}, normals));
    return all;
}

}  // namespace rt
