// origin: a student's: noise against bands of colors
// caught by: the closest of several spheres is seen, in any order of the file (M1, "plusieurs objets")
// sentence: Your color depends on the rays before: a static variable keeps something from one ray to the next. With threads, each picture is another one.
#define trace right_trace
#include "tests/alternatives/step03_sphere/main/smallest_of_all.cpp"
#undef trace

namespace rt {

Color trace(const Scene& scene, const Ray& ray, Context& context) {
    static std::uint32_t state = 1;
    state = 1664525U * state + 1013904223U;
    const Real noise = Real(state >> 8) / Real(1U << 24) - Real(0.5);
    return (1 + noise / 255) * right_trace(scene, ray, context);
}

}  // namespace rt
