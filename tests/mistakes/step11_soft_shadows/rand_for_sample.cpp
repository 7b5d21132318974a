// origin: CR §3.3: rand()
// caught by: the same sample gives the same point in every call (contract)
// sentence: You draw numbers of your own. They crowd here and leave gaps there, and the picture changes with the number of threads. Use the sample.
#define sample_light(...) correct_light_point(__VA_ARGS__)
#include "steps/step11_soft_shadows/reference/soft_shadows.cpp"
#undef sample_light

#include <cstdlib>

namespace rt {

Vec3 sample_light(const Light& light, Vec3 from, Vec2 sample) {
    return correct_light_point(light, from,
                               {Real(std::rand() % 1024) / 1024, Real(std::rand() % 1024) / 1024});
}

}  // namespace rt
