// origin: common in code that computes the index by hand
// caught by: rows and columns are counted apart: a picture wider than high (M1)
// sentence: The index of a pixel is row * width + column: a row is as long as the picture is wide.
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
            image.pixels.at(std::size_t(row * resolution.height + column)) =
                to_rgb(direction_color(ray));
        }
    return image;
}

}  // namespace rt
