// origin: invented: an epsilon on the radius
// caught by: a single sample is seen or not, and --shadow-samples is their number (CR §3.3)
// sentence: You take small lights for points: a scene may have any size. Only a light of radius 0 is a point.
#include "common/render/stage.hpp"

#define trace right_trace
#include "tests/alternatives/step11_soft_shadows/main/plain_loop.cpp"
#undef trace

namespace rt {

Color trace(const Scene& scene, const Ray& ray, Context& context) {
    Scene changed = scene;
    for (Light& light : changed.lights)
        if (light.radius < Real(0.04)) light.radius = 0;
    return right_trace(changed, ray, context);
}

}  // namespace rt
