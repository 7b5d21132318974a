// origin: invented: --shade normal is tested after the mirror
// caught by: the option --shade normal shows the normal (M1)
// sentence: With --shade normal, your mirror shows the normal of what it reflects. It shows its own.
#include "common/render/closest_hit.hpp"
#include "common/render/stage.hpp"

#include "steps/step03_sphere/sphere.hpp"
#include "steps/step12_mirror/mirror.hpp"

namespace rt {

static Color normal_of_what_is_seen(const Scene& scene, const Ray& ray, const Hit& hit,
                                    Context& context) {
    if (hit.material->mirror < 1) return color_from_normal(hit.normal);
    return trace(scene, mirrored(ray, shading_point(hit, ray)), context);
}

}  // namespace rt

#define color_from_normal(normal) normal_of_what_is_seen(scene, ray, *hit, context)
#include "tests/alternatives/step12_mirror/main/own_samples.cpp"
