// What the main.cpp of each stage defines, and the rest of its program is built on.
#pragma once

#include "common/context.hpp"
#include "common/ray.hpp"
#include "common/scene.hpp"

#include <functional>

namespace rt {

/// The ray through the centre of each pixel, for the whole picture.
[[nodiscard]] std::function<Ray(Pixel)> pixel_rays(const Camera& camera, Resolution resolution);

/// The colour that is seen along the ray.
[[nodiscard]] Color trace(const Scene& scene, const Ray& ray, Context& context);

}  // namespace rt
