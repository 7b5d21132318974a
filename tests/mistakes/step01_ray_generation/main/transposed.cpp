// origin: the image is indexed as image(x, y)
// caught by: in a picture of one row, each column has its own ray (MRT §1, j)
// sentence: You write to row "column" of the image: the rows of the picture become its columns.
#include "common/image/to_rgb.hpp"
#include "common/render/stage.hpp"

#include "steps/step01_ray_generation/direction_color.hpp"
#include "steps/step01_ray_generation/ray_generation.hpp"

namespace rt {

Image render(Resolution resolution, Real vertical_fov) {
    Image image(resolution);
    for (int row = 0; row < resolution.height; ++row)
        for (int column = 0; column < resolution.width; ++column) {
            const Ray ray = camera_ray({.row = row, .column = column}, resolution, vertical_fov);
            image[{.row = column, .column = row}] = to_rgb(direction_color(ray));
        }
    return image;
}

}  // namespace rt
