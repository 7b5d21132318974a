// Lights around the ray of a scene of one pixel, of which some are blocked.
#pragma once

#include "tests/suites/kinds.hpp"

#include <cmath>

namespace rt {

/// The ray hits a white wall at 0,0,-4. Up to five lights are around it, each at a cosine of 0.8
/// there; a ball halfway to it blocks about half of them. `option` follows each light.
inline Verdict random_lights_are_blocked(const std::string& option) {
    return for_all(
        [&](Random& random) {
            const auto place = [](double angle, double radius, int z) {
                return std::to_string(radius * std::cos(angle)) + "," +
                       std::to_string(radius * std::sin(angle)) + "," + std::to_string(z);
            };
            const double first = double(random.between(0, 2 * pi));
            std::string lines = "pl 0,0,-4 0,0,1 255,255,255\n";
            Color sum(0);
            for (int light = random.below(5); light >= 0; --light) {
                const double angle = first + 1.2 * light;
                const Rgb color = draw_color(random);
                lines += "L " + place(angle, 3, 0) + " 0.24 " + scene_color(color) + option + "\n";
                if (random.coin())
                    lines = "sp " + place(angle, 1.5, -2) + " 0.4 9,9,9\n" + lines;
                else
                    sum += Real(0.24 * 0.8) * Color(color[0], color[1], color[2]) / Real(255);
            }
            return shows(lines, scaled({255, 255, 255}, sum));
        },
        40);
}

}  // namespace rt
