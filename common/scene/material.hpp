// The surface properties of a shape.
#pragma once

#include "common/math/real.hpp"

namespace rt {
inline namespace RT_PRECISION {

/// The parameters of Phong's model (CR §3.1), and the mirror strength.
struct Material {
    Color color{1};
    Real specular = 0;    ///< 0 to 1: strength of the highlight, which has the light's color
    Real shininess = 32;  ///< exponent of the highlight: a larger one makes it smaller and sharper
    Real mirror = 0;      ///< 0 to 1: fraction of the light that is reflected as by a mirror
};

}  // namespace RT_PRECISION
}  // namespace rt
