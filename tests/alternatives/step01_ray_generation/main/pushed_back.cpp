// right: an empty list of pixels that grows
#include "common/image/to_rgb.hpp"
#include "common/render/stage.hpp"

#include "steps/step01_ray_generation/direction_color.hpp"
#include "steps/step01_ray_generation/ray_generation.hpp"

namespace rt {

Image render(Resolution resolution, Real vertical_fov) {
    Image image;
    image.resolution = resolution;
    for (int i = 0; i < resolution.height; i++)
        for (int j = 0; j < resolution.width; j++)
            image.pixels.push_back(
                to_rgb(direction_color(camera_ray({i, j}, resolution, vertical_fov))));
    return image;
}

}  // namespace rt
