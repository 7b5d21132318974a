// attack: a loop over the pixels that returns a larger picture than memory has room for
// ceiling: 0
// stage: step01_ray_generation
// file: main.cpp
#include "common/render/stage.hpp"

namespace rt {

Image render(Resolution /*resolution*/, Real /*vertical_fov*/) {
    return Image({.width = 100000, .height = 100000});
}

}  // namespace rt
