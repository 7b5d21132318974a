// Stage 1: a ray through every pixel (MRT §1; M1, "générer un rayon").
//
//   MRT         here
//   i, j        pixel.row, pixel.column
//   W, H        resolution.width, resolution.height
//   FOV         vertical_fov, in radians
//   pixFinal    pixel_on_screen(…)
#pragma once

#include "common/geometry/ray.hpp"
#include "common/image/pixel.hpp"

namespace rt {

/// pixFinal (MRT §1): the position of the pixel's center on the plane z = −1 in front of the
/// camera, x to the right and y up. `vertical_fov`, 0 to π radians, is the angle between the top
/// and the bottom edge.
[[nodiscard]] Vec2 pixel_on_screen(Pixel pixel, Resolution resolution, Real vertical_fov);

/// The ray from the origin through the pixel's center, for a camera that faces −z. Its direction
/// ends on the plane z = −1, so that t is the depth of a point.
[[nodiscard]] Ray camera_ray(Pixel pixel, Resolution resolution, Real vertical_fov);

/// The same ray computed with M1's inverse matrices. It starts at `camera_to_world` · (0, 0, 0, 1),
/// and t = 1 is the point `image_to_world` · (x, y, 1, 1) on the far plane; x and y are the pixel's
/// center in pixels, from the image's top left corner. Both points are divided by their w.
[[nodiscard]] Ray unprojected_ray(Pixel pixel, const Mat4& camera_to_world,
                                  const Mat4& image_to_world);

}  // namespace rt
