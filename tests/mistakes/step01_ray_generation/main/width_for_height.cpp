// origin: common
// caught by: in a picture of one column, each row has its own ray (MRT §1, i)
// sentence: The loop over the rows runs to the width, and the loop over the columns to the height.
#include "common/image/to_rgb.hpp"
#include "common/render/stage.hpp"

#include "steps/step01_ray_generation/direction_color.hpp"
#include "steps/step01_ray_generation/ray_generation.hpp"

namespace rt {

Image render(Resolution resolution, Real vertical_fov) {
    Image image(resolution);
    for (int row = 0; row < resolution.width; ++row)
        for (int column = 0; column < resolution.height; ++column) {
            const Ray ray = camera_ray({.row = row, .column = column}, resolution, vertical_fov);
            image[{.row = row, .column = column}] = to_rgb(direction_color(ray));
        }
    return image;
}

}  // namespace rt
