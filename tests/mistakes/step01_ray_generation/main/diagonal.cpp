// origin: one loop for both
// caught by: every pixel of a square picture has its own ray (M1)
// sentence: One variable counts rows and columns: only the diagonal is drawn.
#include "common/image/to_rgb.hpp"
#include "common/render/stage.hpp"

#include "steps/step01_ray_generation/direction_color.hpp"
#include "steps/step01_ray_generation/ray_generation.hpp"

namespace rt {

Image render(Resolution resolution, Real vertical_fov) {
    Image image(resolution);
    for (int i = 0; i < resolution.height && i < resolution.width; ++i)
        image[{.row = i, .column = i}] =
            to_rgb(direction_color(camera_ray({.row = i, .column = i}, resolution, vertical_fov)));
    return image;
}

}  // namespace rt
