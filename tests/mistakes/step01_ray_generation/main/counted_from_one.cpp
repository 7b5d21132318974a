// origin: common, from languages that count from 1
// caught by: a picture of one pixel shows the ray through its center (MRT §1)
// sentence: Rows and columns count from 0: the first row and the first column stay black.
#include "common/image/to_rgb.hpp"
#include "common/render/stage.hpp"

#include "steps/step01_ray_generation/direction_color.hpp"
#include "steps/step01_ray_generation/ray_generation.hpp"

namespace rt {

Image render(Resolution resolution, Real vertical_fov) {
    Image image(resolution);
    for (int row = 1; row < resolution.height; ++row)
        for (int column = 1; column < resolution.width; ++column) {
            const Ray ray = camera_ray({.row = row, .column = column}, resolution, vertical_fov);
            image[{.row = row, .column = column}] = to_rgb(direction_color(ray));
        }
    return image;
}

}  // namespace rt
