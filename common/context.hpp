// What goes along with the rays of one pixel.
#pragma once

#include <cstdint>

namespace rt {

class Story;

/// How a hit becomes a colour before there is light (M1).
enum class Shading {
    torch,   ///< the shape's colour under a torch held at the eye
    normal,  ///< abs(normal)
};

struct Context {
    Shading shading = Shading::torch;
    Story* story = nullptr;  ///< told everything, if there is one: `--pixel`
    std::int64_t rays = 0;   ///< how many were sent
};

}  // namespace rt
