#include "common/program/make_picture.hpp"

#include "common/image/animation.hpp"
#include "common/program/turntable.hpp"
#include "common/program/used_options.hpp"
#include "common/render/render.hpp"
#include "common/system/escaping.hpp"
#include "common/system/terminal.hpp"
#include "common/system/text.hpp"
#include "common/system/translation.hpp"

#include <chrono>

namespace rt {

bool make_animation(const Program& program, const Options& options, const Scene& scene,
                    const std::atomic<bool>& stop) {
    constexpr int milliseconds = 5000;  // for the whole way around
    const std::optional<Vec3> middle = middle_of_shapes(scene);
    if (!middle)
        throw InputError({options.scene},
                         "has no shape but planes: --turn needs another, to go around it");
    const auto start = std::chrono::steady_clock::now();
    const int frames = *options.turn;
    Scene turning = scene;
    Animation animation;
    {
        Progress progress(!options.quiet && errors_on_terminal(), frames * scene.resolution.height);
        for (int frame = 0; frame < frames; ++frame) {
            turning.cameras[0] = turned(scene.cameras[0], *middle, Real(frame) / Real(frames));
            const auto rendering = render(turning, {.threads = options.threads,
                                                    .settings = options.settings,
                                                    .row_done = [&] { progress.advance(); },
                                                    .stop = &stop});
            if (!rendering) return false;
            animation.add(rendering->image);
        }
    }
    animation.write(options.output, milliseconds / frames,
                    picture_texts(program, options, scene.resolution), options.settings.gamma);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    if (options.quiet) return true;
    print_line(tr_text(one_line(options.output) + ": " + std::to_string(frames) + " frames of " +
                       size_text(scene.resolution) + " pixels, " + name(options.precision) +
                       formatted(", %.2f s", seconds.count())));
    return true;
}

}  // namespace rt
