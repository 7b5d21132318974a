// One to 256 rays through each pixel, at regular, jittered and well-spread points, and adaptive
// numbers of rays: how far the picture is from one of 1,024 rays, and how long it takes.
#include "common/program/load_meshes.hpp"
#include "common/render/pixel_samples.hpp"
#include "common/render/render.hpp"
#include "common/scene_file/reader.hpp"
#include "common/system/hash.hpp"

#include "steps/step02_camera_basis/camera_basis.hpp"

#include "tests/measurements/accuracy/time_ratio.hpp"

#include <cstdio>
#include <functional>

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

class Study {
public:
    explicit Study(const char* name)
        : name_(name),
          scene_(
              load_scene(RAYSTEPS_ROOT "/scenes/" + std::string(name) + ".rt", orthonormal_basis)) {
        load_meshes(scene_);
        build_acceleration(scene_);
        scene_.resolution = {.width = 128, .height = 96};
        exact_ = drawn({.pixel_samples = 1024});
    }

    void measure() {
        for (const int side : {1, 2, 4, 8, 16}) {
            const int count = side * side;
            print("regular", count, [&] { return drawn_at(scene_, side, regular); });
            if (count > 1)
                print("jittered", count, [&] { return drawn_at(scene_, side, jittered); });
        }
        for (int count = 1; count <= 256; count *= 2)
            print("spread", count, [&] { return drawn({.pixel_samples = count}); });
        for (const double error : {32, 16, 8, 4, 2, 1})
            print("adaptive", error,
                  [&] { return drawn({.pixel_samples = 1024, .pixel_error = error}); });
    }

private:
    [[nodiscard]] Image drawn(const RenderSettings& settings) const {
        return render(scene_, {.settings = settings}).value().image;
    }

    /// The time is in units of the picture of one ray through each pixel.
    void print(const char* way, double asked, const std::function<Image()>& draw) const {
        const TimeRatio ratio = time_ratio([&] { return timed(draw); },
                                           [&] { return timed([&] { return drawn({}); }); });
        const Difference off = difference(ratio.image, exact_);
        std::printf("%s,%s,%g,%.4f,%.4f,%.4f,%.4g,%d,%.5f\n", name_, way, asked, ratio.time,
                    ratio.least, ratio.greatest, off.error, off.most, off.seen);
        std::fflush(stdout);
    }

    const char* name_;
    Scene scene_;
    Image exact_;
};

}  // namespace

int main(int count, char** arguments) {
    const std::string only = count > 1 ? arguments[1] : "";
    std::puts("scene,way,asked,time,least,greatest,error,most,seen");
    for (const char* scene : {"step04_plane", "cornell_box", "step09_phong", "step11_soft_shadows",
                              "step12_mirror", "step13_meshes"})
        if (only.empty() || only == scene) Study(scene).measure();
}
