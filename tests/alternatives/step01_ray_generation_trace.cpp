// right columns_first: columns outside, rows inside
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

// right from_the_bottom: rows from the bottom, columns from the right
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

// right one_counter: one loop over the numbers of all pixels
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

// right pushed_back: an empty list of pixels that grows
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
