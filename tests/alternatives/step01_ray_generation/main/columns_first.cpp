// right: columns outside, rows inside
#include "common/image/to_rgb.hpp"
#include "common/render/stage.hpp"

#include "steps/step01_ray_generation/direction_color.hpp"
#include "steps/step01_ray_generation/ray_generation.hpp"

namespace rt {

Image render(Resolution resolution, Real vertical_fov) {
    Image image(resolution);
    for (int x = 0; x < resolution.width; x++) {
        for (int y = 0; y < resolution.height; y++) {
            Pixel pixel;
            pixel.row = y;
            pixel.column = x;
            image[pixel] = to_rgb(direction_color(camera_ray(pixel, resolution, vertical_fov)));
        }
    }
    return image;
}

}  // namespace rt
