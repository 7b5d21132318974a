// What the command line says about how a picture looks and what it may cost.
#pragma once

namespace rt {

/// How a hit becomes a colour.
enum class Shading {
    color,   ///< as the stage does: by a torch at the eye (M1), from stage 9 on by the lights
    normal,  ///< abs(normal)
};

/// Which of Phong's terms are shown.
enum class Term { all, ambient, diffuse, specular };

constexpr int most_shadow_samples = 1 << 20;
constexpr int most_depth = 1000;

struct Look {
    Shading shading = Shading::color;
    Term term = Term::all;
    int shadow_samples = 16;  ///< rays to a light with a size, at most
    double shadow_error = 0;  ///< fewer, once the colour is estimated to be off by less, of 255
    int shadow_agree = 0;     ///< or once so many all reached the light, or none; 0 for never
    int depth = 8;            ///< mirror upon mirror, at most
};

}  // namespace rt
