// attack: a main.cpp of stage 1 that calls the program's loop over the pixels, without its header
// ceiling: 0
// stage: step01_ray_generation
// file: main.cpp
// compiles: no
// message: Your file calls rt::render
#include "common/render/stage.hpp"

namespace rt {

struct RenderJob {
    int threads = 2;
};
struct Rendering {
    Image image;
};

std::optional<Rendering> render(const Scene& scene, const RenderJob& job);

Image render(Resolution resolution, Real vertical_fov) {
    Scene scene;
    scene.resolution = resolution;
    scene.cameras = {{.fov = vertical_fov}};
    return render(scene, {})->image;
}

}  // namespace rt
