// attack: a main.cpp of stage 1 that has the tuning's trials trace each pixel, without their header
// ceiling: 0
// stage: step01_ray_generation
// file: main.cpp
// compiles: no
// message: Your file calls rt::render_pixels
#include "common/render/stage.hpp"

#include <array>
#include <atomic>
#include <span>
#include <vector>

namespace rt {

struct TrialRequest {
    std::span<const Pixel> pixels;
    int round = 0;
    int at_least = 0;
    int threads = 1;
    const std::atomic<bool>* stop = nullptr;
};
struct TrialSample {
    std::vector<std::array<double, 3>> shades;
    std::vector<int> light_rays;
    double rays = 0;
    double seconds = 0;
};

TrialSample render_pixels(const Scene& scene, const RenderSettings& settings,
                          const TrialRequest& request);

Image render(Resolution resolution, Real vertical_fov) {
    Scene scene;
    scene.resolution = resolution;
    scene.cameras = {{.fov = vertical_fov}};
    Image image(resolution);
    for (Pixel pixel; pixel.row < resolution.height; ++pixel.row)
        for (pixel.column = 0; pixel.column < resolution.width; ++pixel.column) {
            const auto color = render_pixels(scene, {}, {.pixels = {&pixel, 1}}).shades[0];
            for (std::size_t i = 0; i < 3; ++i) image[pixel][i] = std::uint8_t(color[i] + 0.5);
        }
    return image;
}

}  // namespace rt
