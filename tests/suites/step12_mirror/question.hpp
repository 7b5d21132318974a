// The text of a question to this stage.
#pragma once

#include "tests/kit/light.hpp"

#include <string>

namespace rt {

inline std::string question(const Ray& ray, const ShadingPoint& surface) {
    return "mirrored(" + code(ray) + ",\n           " + code(surface) + ")";
}

}  // namespace rt
