// origin: seen in student repositories
// caught by: in a picture of one row, each column has its own ray (MRT §1, j)
// sentence: The pixel of the ray has its row and its column exchanged: the row goes down, the column goes to the right.
#include "common/image/to_rgb.hpp"
#include "common/render/stage.hpp"

#include "steps/step01_ray_generation/direction_color.hpp"
#include "steps/step01_ray_generation/ray_generation.hpp"

namespace rt {

Image render(Resolution resolution, Real vertical_fov) {
    Image image(resolution);
    for (int row = 0; row < resolution.height; ++row)
        for (int column = 0; column < resolution.width; ++column) {
            const Ray ray = camera_ray({.row = column, .column = row}, resolution, vertical_fov);
            image[{.row = row, .column = column}] = to_rgb(direction_color(ray));
        }
    return image;
}

}  // namespace rt
