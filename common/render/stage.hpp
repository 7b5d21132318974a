// The functions that each stage defines, mostly in its main.cpp, and the rest of its program calls.
// In a unity build (common/cmake/stage.cmake), functions marked gnu::flatten have all their calls
// inlined.
#pragma once

#include "common/geometry/ray.hpp"
#include "common/image/image.hpp"
#include "common/math/basis.hpp"
#include "common/math/vector.hpp"
#include "common/render/context.hpp"
#include "common/scene/scene.hpp"

#include <optional>

namespace rt {
inline namespace RT_PRECISION {

/// The constants of rays through pixels, computed once for each picture.
struct PixelRays {
    Resolution resolution;
    Real vertical_fov = 0;
    Basis basis;  ///< basis of the camera, like `position` from stage 2 on
    Vec3 position;

    /// Returns the ray through the pixel's center.
    [[nodiscard, gnu::flatten]] Ray operator()(Pixel pixel) const;
};

}  // namespace RT_PRECISION

/// The color of a ray that hits nothing: that of the scene's sky in its direction, or black.
[[nodiscard]] inline Color background(const Scene& scene, const Ray& ray) {
    if (!scene.sky) return Color(0);
    const Real share = (unit(ray.direction).y + Real(1)) / Real(2);
    return (Real(1) - share) * scene.sky->bottom + share * scene.sky->top;
}

/// The constants of the rays of one picture.
[[nodiscard]] PixelRays pixel_rays(const Camera& camera, Resolution resolution);

/// The picture of the directions of all camera rays: the loop over the pixels, on one thread. Only
/// stage 1 defines it.
[[nodiscard]] Image render(Resolution resolution, Real vertical_fov);

/// The scene's picture by that loop, in stage 1; in all later stages nothing. Throws InputError if
/// the loop returns an image of another size. The program of stage 1 is linked to pixel_rays.cpp of
/// stage 1, and all others to that of stage 2, which SHARES_ANEW (common/cmake/stage.cmake).
[[nodiscard]] std::optional<Image> picture_by_own_loop(const Scene& scene);

/// The color seen along the ray.
[[nodiscard, gnu::flatten]] Color trace(const Scene& scene, const Ray& ray, Context& context);

}  // namespace rt
