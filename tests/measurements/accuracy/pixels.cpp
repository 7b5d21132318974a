// One to 256 rays through each pixel, at regular, jittered and evenly spread points, and adaptive
// numbers of rays: how far the picture is from one of 1,024 rays, and how long it takes.
#include "common/program/load_meshes.hpp"
#include "common/render/pixel_samples.hpp"
#include "common/render/render.hpp"
#include "common/scene_file/reader.hpp"
#include "common/system/hash.hpp"

#include "steps/step02_camera_basis/camera_basis.hpp"

#include "tests/measurements/accuracy/drawing.hpp"

#include <cmath>
#include <cstdio>
#include <ctime>
#include <limits>

using namespace rt;

namespace {

/// A point in one of side² equal squares.
using Place = Vec2 (*)(Pixel pixel, int index, int side);

Vec2 in_square(int index, int side, Vec2 within) {
    return {(Real(index % side) + within.x) / Real(side),
            (Real(index / side) + within.y) / Real(side)};
}

Vec2 regular(Pixel /*pixel*/, int index, int side) {
    return in_square(index, side, {Real(0.5), Real(0.5)});
}

/// At random in the square: a sequence's first point is, over the seeds.
Vec2 jittered(Pixel pixel, int index, int side) {
    const std::uint32_t seed = mixed_bits(sample_seed(pixel, 0, 0) + std::uint32_t(index));
    return in_square(index, side, spread_sample(0, seed));
}

Image drawn_at(const Scene& scene, int side, Place place) {
    const FinerRays rays(scene.cameras.front(), scene.resolution);
    Image image(scene.resolution);
    const int count = side * side;
    Context context{.settings = shared_settings({.pixel_samples = count})};
    for (Pixel pixel; pixel.row < scene.resolution.height; ++pixel.row)
        for (pixel.column = 0; pixel.column < scene.resolution.width; ++pixel.column) {
            context.whole_pixel = pixel;
            Color sum(0);
            for (context.sample = 0; context.sample < count; ++context.sample) {
                context.pixel = FinerRays::at(pixel, place(pixel, context.sample, side));
                const Color color = trace(scene, rays(context.pixel), context);
                sum += glm::clamp(color, Color(0), Color(1));
            }
            image[pixel] = to_rgb(sum / Real(count));
        }
    return image;
}

/// Prints the error of a picture and the processor's time, the shortest of several runs.
template <class Draw>
void measure(const char* scene, const char* way, double asked, const Image& exact, Draw draw) {
    Image image;
    double seconds = std::numeric_limits<double>::infinity();
    for (double all = 0; all < 0.1;) {
        const std::clock_t start = std::clock();
        image = draw();
        const double run = double(std::clock() - start) / CLOCKS_PER_SEC;
        seconds = std::min(seconds, run);
        all += run;
    }
    const Difference off = difference(image, exact);
    std::printf("%s,%s,%g,%.5f,%.4g,%d,%.5f\n", scene, way, asked, seconds, off.error, off.most,
                off.seen);
    std::fflush(stdout);
}

void measure_scene(const char* name) {
    Scene scene =
        load_scene(RAYSTEPS_ROOT "/scenes/" + std::string(name) + ".rt", orthonormal_basis);
    load_meshes(scene);
    build_acceleration(scene);
    scene.resolution = {.width = 128, .height = 96};
    const auto drawn = [&](const RenderSettings& settings) {
        return render(scene, {.settings = settings}).value().image;
    };
    const Image exact = drawn({.pixel_samples = 1024});
    for (const int side : {1, 2, 4, 8, 16}) {
        const int count = side * side;
        measure(name, "regular", count, exact, [&] { return drawn_at(scene, side, regular); });
        if (count > 1)
            measure(name, "jittered", count, exact,
                    [&] { return drawn_at(scene, side, jittered); });
    }
    for (int count = 1; count <= 256; count *= 2)
        measure(name, "spread", count, exact, [&] { return drawn({.pixel_samples = count}); });
    for (const double error : {32, 16, 8, 4, 2, 1})
        measure(name, "adaptive", error, exact,
                [&] { return drawn({.pixel_samples = 1024, .pixel_error = error}); });
}

}  // namespace

int main() {
    std::puts("scene,way,asked,seconds,error,most,seen");
    for (const char* scene : {"step04_plane", "cornell_box", "step09_phong", "step11_soft_shadows",
                              "step12_mirror", "step13_meshes"})
        measure_scene(scene);
}
