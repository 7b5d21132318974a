// origin: a student's: the end of the interval is replaced
// caught by: every kind of shape casts a shadow, up to both ends of its way (CR §3.2)
// sentence: Your shadow rays to an area light go on behind it. Take the whole of shadow_ray(surface, aim): its interval ends at the light.
#include "steps/step10_shadows/shadows.hpp"
#include "steps/step11_soft_shadows/soft_shadows.hpp"

#include <utility>

namespace rt {

namespace {

bool is_sample = false;  // the next shadow ray is one to a sample

ShadowRay changed(ShadowRay way) {
    if (std::exchange(is_sample, false)) way.interval.max = infinity;
    return way;
}

}  // namespace

}  // namespace rt

#define sample_light(...) (is_sample = true, sample_light(__VA_ARGS__))
#define shadow_ray(...) changed(shadow_ray(__VA_ARGS__))
#include "tests/alternatives/step11_soft_shadows/main/plain_loop.cpp"
