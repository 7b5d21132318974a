// origin: a student's: the angle limited to 1° to 179°
// caught by: pixels are equal squares around the middle, in any picture (MRT §1)
// sentence: You limit the field of view. It may have any angle below 180°.
#include <algorithm>

#define pixel_on_screen(...) correct_pixel_on_screen(__VA_ARGS__)
#include "steps/step01_ray_generation/reference/ray_generation.cpp"
#undef pixel_on_screen

namespace rt {

Vec2 pixel_on_screen(Pixel pixel, Resolution resolution, Real vertical_fov) {
    const Real fov = std::min(vertical_fov, 179 * pi / 180);
    return correct_pixel_on_screen(pixel, resolution, fov);
}

}  // namespace rt
