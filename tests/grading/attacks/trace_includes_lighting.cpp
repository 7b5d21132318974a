// attack: a main.cpp that includes the project's loop over the samples
// ceiling: 0
// stage: step11_soft_shadows
// file: main.cpp
// compiles: no
// message: lighting.hpp, which this stage must not include
#include "common/render/stage.hpp"

#include "steps/step11_soft_shadows/lighting.hpp"

namespace rt {

Color trace(const Scene&, const Ray&, Context&) {
    return Color(0);
}

}  // namespace rt
