// right: one loop over the numbers of all pixels
#include "common/image/to_rgb.hpp"
#include "common/render/stage.hpp"

#include "steps/step01_ray_generation/direction_color.hpp"
#include "steps/step01_ray_generation/ray_generation.hpp"

namespace rt {

Image render(Resolution resolution, Real vertical_fov) {
    Image image(resolution);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const Pixel pixel{.row = int(i) / resolution.width, .column = int(i) % resolution.width};
        image.pixels[i] = to_rgb(direction_color(camera_ray(pixel, resolution, vertical_fov)));
    }
    return image;
}

}  // namespace rt
