#include "docs/figures/engine/traces.hpp"

#include "common/render/render.hpp"
#include "common/render/stage.hpp"

#include <array>

// Each stage's main.cpp defines trace: here under names of their own.
#include "steps/step01_ray_generation/main.cpp"
#define trace trace_of_step02
#include "steps/step02_camera_basis/main.cpp"
#undef trace
#define trace trace_of_step03
#include "steps/step03_sphere/main.cpp"
#undef trace
#define trace trace_of_step04
#include "steps/step04_plane/main.cpp"
#undef trace
#define trace trace_of_step05
#include "steps/step05_triangle/main.cpp"
#undef trace
#define trace trace_of_step06
#include "steps/step06_square/main.cpp"
#undef trace
#define trace trace_of_step07
#include "steps/step07_cylinder/main.cpp"
#undef trace
#define trace trace_of_step08
#include "steps/step08_cone/main.cpp"
#undef trace
#define trace trace_of_step09
#include "steps/step09_phong/main.cpp"
#undef trace
#define trace trace_of_step10
#include "steps/step10_shadows/main.cpp"
#undef trace
#define trace trace_of_step11
#include "steps/step11_soft_shadows/main.cpp"
#undef trace
#define trace trace_of_step12
#include "steps/step12_mirror/main.cpp"
#undef trace
#define trace trace_of_step13
#include "steps/step13_meshes/main.cpp"
#undef trace

namespace rt {

namespace {

using Trace = Color (*)(const Scene& scene, const Ray& ray, Context& context);

constexpr std::array<Trace, 14> traces = {
    nullptr,         nullptr,         trace_of_step02, trace_of_step03, trace_of_step04,
    trace_of_step05, trace_of_step06, trace_of_step07, trace_of_step08, trace_of_step09,
    trace_of_step10, trace_of_step11, trace_of_step12, trace_of_step13};

int stage = 2;

}  // namespace

Color trace(const Scene& scene, const Ray& ray, Context& context) {
    return traces[std::size_t(stage)](scene, ray, context);
}

void book::choose_stage(int chosen) {
    stage = chosen;
}

Image book::rendered(const Scene& scene) {
    if (stage == 1)
        return render(scene.resolution, vertical_fov(scene.cameras.front(), scene.resolution));
    return render(scene, {})->image;
}

}  // namespace rt
