// attack: a main.cpp of stage 3 that calls the library's test of a list by its symbol
// ceiling: 0
// stage: step03_sphere
// file: main.cpp
// compiles: no
#include "common/render/context.hpp"
#include "common/render/stage.hpp"
#include "steps/step03_sphere/sphere.hpp"
namespace rt {
void test(void*, const void*) asm(
    "_ZN2rt3f6410ClosestHit9test_listINS0_6SphereEEEvRKSt6vectorINS0_9PrimitiveIT_EESaIS6_EE");
Color trace(const Scene& scene, const Ray&, Context&) {
    alignas(64) char room[4096] = {};
    test(room, &scene.spheres);
    return Color(room[8]);
}
}  // namespace rt
