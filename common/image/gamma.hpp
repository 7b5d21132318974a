// The encoding of colors in a picture file.
#pragma once

#include <algorithm>
#include <cmath>

namespace rt {

/// The relation between light and the numbers of a picture file.
enum class Gamma {
    unstated,  ///< proportional, and the file does not say so: the numbers of the documents
    linear,    ///< proportional, and the file says so
    srgb,      ///< encoded for screens (IEC 61966-2-1), and the file says so
};

/// The encoded value of a fraction of full light, from 0 to 1. Smaller and larger values are
/// clamped; NaN stays NaN.
template <class Number>
[[nodiscard]] Number encoded(Number light, Gamma gamma) {
    const Number value = std::min(std::max(light, Number(0)), Number(1));
    if (gamma != Gamma::srgb || std::isnan(light)) return std::isnan(light) ? light : value;
    return value <= Number(0.0031308)
               ? Number(12.92) * value
               : Number(1.055) * std::pow(value, 1 / Number(2.4)) - Number(0.055);
}

}  // namespace rt
