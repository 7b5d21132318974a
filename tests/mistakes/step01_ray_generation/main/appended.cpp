// origin: push_back after the constructor
// caught by: a picture of one pixel shows the ray through its center (MRT §1)
// sentence: Image(resolution) already has all pixels. push_back adds as many behind them.
#include "common/image/to_rgb.hpp"
#include "common/render/stage.hpp"

#include "steps/step01_ray_generation/direction_color.hpp"
#include "steps/step01_ray_generation/ray_generation.hpp"

namespace rt {

Image render(Resolution resolution, Real vertical_fov) {
    Image image(resolution);
    for (int row = 0; row < resolution.height; ++row)
        for (int column = 0; column < resolution.width; ++column)
            image.pixels.push_back(to_rgb(direction_color(
                camera_ray({.row = row, .column = column}, resolution, vertical_fov))));
    return image;
}

}  // namespace rt
