// origin: the ray is made outside of the inner loop
// caught by: in a picture of one row, each column has its own ray (MRT §1, j)
// sentence: The ray is made once for each row: every pixel needs a ray of its own.
#include "common/image/to_rgb.hpp"
#include "common/render/stage.hpp"

#include "steps/step01_ray_generation/direction_color.hpp"
#include "steps/step01_ray_generation/ray_generation.hpp"

namespace rt {

Image render(Resolution resolution, Real vertical_fov) {
    Image image(resolution);
    for (int row = 0; row < resolution.height; ++row) {
        const Ray ray = camera_ray({.row = row, .column = 0}, resolution, vertical_fov);
        for (int column = 0; column < resolution.width; ++column)
            image[{.row = row, .column = column}] = to_rgb(direction_color(ray));
    }
    return image;
}

}  // namespace rt
