// A ray for every pixel; the color shows its direction.
#include "common/render/stage.hpp"

#include "common/image/to_rgb.hpp"

#include "steps/step01_ray_generation/direction_color.hpp"
#include "steps/step01_ray_generation/ray_generation.hpp"

namespace rt {

Image render(Resolution resolution, Real vertical_fov) {
    Image image(resolution);
    for (Pixel pixel; pixel.row < resolution.height; ++pixel.row)
        for (pixel.column = 0; pixel.column < resolution.width; ++pixel.column)
            image[pixel] = to_rgb(direction_color(camera_ray(pixel, resolution, vertical_fov)));
    return image;
}

}  // namespace rt
