// right: rows from the bottom, columns from the right
#include "common/image/to_rgb.hpp"
#include "common/render/stage.hpp"

#include "steps/step01_ray_generation/direction_color.hpp"
#include "steps/step01_ray_generation/ray_generation.hpp"

namespace rt {

Image render(Resolution resolution, Real vertical_fov) {
    Image image(resolution);
    for (int i = resolution.height - 1; i >= 0; --i)
        for (int j = resolution.width - 1; j >= 0; --j) {
            const Ray ray = camera_ray({.row = i, .column = j}, resolution, vertical_fov);
            image[{.row = i, .column = j}] = to_rgb(direction_color(ray));
        }
    return image;
}

}  // namespace rt
