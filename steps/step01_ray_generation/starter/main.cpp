// Your main.cpp of stage 1: the picture, pixel by pixel (M1, "bilan"). The page's part "The loop
// over the pixels" explains it. Without this file, the program uses the main.cpp in the folder
// above.
#include "common/render/stage.hpp"

#include "common/image/to_rgb.hpp"
#include "common/stages/todo.hpp"

#include "steps/step01_ray_generation/direction_color.hpp"
#include "steps/step01_ray_generation/ray_generation.hpp"

namespace rt {

Image render(Resolution resolution, Real vertical_fov) {
    Image image(resolution);  // all pixels are black
    // For every row, and in it for every column: the camera_ray of the pixel, and its color
    // to_rgb(direction_color(ray)) at image[pixel], where pixel is Pixel{.row = …, .column = …}.
    RT_TODO(image, vertical_fov);
    return image;
}

}  // namespace rt
