// origin: the angle of the first scene is written down
// caught by: the field of view is the one that is given (MRT §1)
// sentence: The field of view is a constant, not the vertical_fov that render receives.
#include "common/image/to_rgb.hpp"
#include "common/render/stage.hpp"

#include "steps/step01_ray_generation/direction_color.hpp"
#include "steps/step01_ray_generation/ray_generation.hpp"

namespace rt {

Image render(Resolution resolution, Real vertical_fov) {
    Image image(resolution);
    for (int row = 0; row < resolution.height; ++row)
        for (int column = 0; column < resolution.width; ++column) {
            const Ray ray = camera_ray({.row = row, .column = column}, resolution, pi / 2);
            image[{.row = row, .column = column}] = to_rgb(direction_color(ray));
        }
    return image;
}

}  // namespace rt
