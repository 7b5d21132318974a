// What the main.cpp of each stage defines, and the rest of its program is built on. Where all of it
// is compiled as one (steps/stage.cmake), what is gnu::flatten calls nothing, but has it inlined.
#pragma once

#include "common/basis.hpp"
#include "common/context.hpp"
#include "common/ray.hpp"
#include "common/scene.hpp"

namespace rt::inline RT_PRECISION {

/// What rays through pixels are made of, worked out once a picture.
struct PixelRays {
    Resolution resolution;
    Real vertical_fov = 0;
    Basis basis;  ///< of the camera, as its position; from stage 2 on
    Vec3 position;

    /// The ray through the pixel's centre.
    [[nodiscard, gnu::flatten]] Ray operator()(Pixel pixel) const;
};

}  // namespace rt::inline RT_PRECISION

namespace rt {

/// For the whole picture.
[[nodiscard]] PixelRays pixel_rays(const Camera& camera, Resolution resolution);

/// The colour that is seen along the ray.
[[nodiscard, gnu::flatten]] Color trace(const Scene& scene, const Ray& ray, Context& context);

}  // namespace rt
