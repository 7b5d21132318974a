// attack: a main.cpp that calls the stage's own trace of a mirror, without its header
// ceiling: 0
// stage: step12_mirror
// file: main.cpp
// compiles: no
// message: Your file calls rt::reflection
#include "common/render/stage.hpp"

#include "steps/step11_soft_shadows/lighting.hpp"

namespace rt {

Color reflection(const Scene& scene, const Ray& ray, const ShadingPoint& surface, Context& context);

Color trace(const Scene& scene, const Ray& ray, Context& context) {
    return reflection(scene, ray, {}, context);
}

}  // namespace rt
