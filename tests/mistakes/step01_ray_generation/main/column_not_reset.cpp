// origin: a loop as while, with one counter that is not reset
// caught by: in a picture of one column, each row has its own ray (MRT §1, i)
// sentence: The column starts at 0 in the first row only: set it to 0 in each row.
#include "common/image/to_rgb.hpp"
#include "common/render/stage.hpp"

#include "steps/step01_ray_generation/direction_color.hpp"
#include "steps/step01_ray_generation/ray_generation.hpp"

namespace rt {

Image render(Resolution resolution, Real vertical_fov) {
    Image image(resolution);
    int column = 0;
    for (int row = 0; row < resolution.height; ++row)
        for (; column < resolution.width; ++column) {
            const Ray ray = camera_ray({.row = row, .column = column}, resolution, vertical_fov);
            image[{.row = row, .column = column}] = to_rgb(direction_color(ray));
        }
    return image;
}

}  // namespace rt
