// origin: the size of the first picture is written down
// caught by: a picture of one pixel shows the ray through its center (MRT §1)
// sentence: The image always has 640 x 480 pixels: its size must be the resolution that render receives.
#include "common/image/to_rgb.hpp"
#include "common/render/stage.hpp"

#include "steps/step01_ray_generation/direction_color.hpp"
#include "steps/step01_ray_generation/ray_generation.hpp"

namespace rt {

Image render(Resolution resolution, Real vertical_fov) {
    Image image(Resolution{});
    resolution = Resolution{};
    for (int row = 0; row < resolution.height; ++row)
        for (int column = 0; column < resolution.width; ++column) {
            const Ray ray = camera_ray({.row = row, .column = column}, resolution, vertical_fov);
            image[{.row = row, .column = column}] = to_rgb(direction_color(ray));
        }
    return image;
}

}  // namespace rt
