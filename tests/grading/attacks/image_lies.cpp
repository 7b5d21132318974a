// attack: a loop whose picture has a resolution without the pixels
// ceiling: 0
// stage: step01_ray_generation
// file: main.cpp
#include "common/render/stage.hpp"
namespace rt {
Image render(Resolution resolution, Real) {
    Image image;
    image.resolution = resolution;
    return image;
}
}  // namespace rt
