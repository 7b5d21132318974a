// What a shape is made of.
#pragma once

#include "common/real.hpp"

namespace rt::inline RT_PRECISION {

struct Material {
    Color color{1};
    Real specular = 0;    ///< 0 to 1: how strong its highlight is, which has the light's colour
    Real shininess = 32;  ///< the highlight's exponent: the larger, the smaller and sharper
    Real mirror = 0;      ///< 0 to 1: the share of the light that it reflects as a mirror
};

}  // namespace rt::inline RT_PRECISION
