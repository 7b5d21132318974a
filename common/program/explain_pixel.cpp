#include "common/program/make_picture.hpp"

#include "common/explain/pixel_log.hpp"
#include "common/program/used_options.hpp"
#include "common/render/pixel_samples.hpp"
#include "common/render/render.hpp"
#include "common/stages/stages.hpp"
#include "common/system/translation.hpp"

#include <iostream>
#include <streambuf>

namespace rt {

namespace {

/// Prints each line in the reader's language once it is whole.
class TranslatedLines : public std::streambuf {
protected:
    int_type overflow(int_type c) override {
        line_ += char(c);
        if (c != '\n') return c;
        line_.pop_back();
        std::cout << tr_line(line_) << '\n';
        line_.clear();
        return c;
    }

private:
    std::string line_;
};

std::string bytes_text(Rgb rgb) {
    return std::to_string(rgb[0]) + ", " + std::to_string(rgb[1]) + ", " + std::to_string(rgb[2]);
}

/// Logs the color that the picture has with --samples. The rest of the log is that of the ray
/// through the pixel's center, which is none of the samples.
void log_mean(PixelLog& log, const RenderSettings& settings, const Scene& scene, Pixel pixel) {
    Context context{.settings = shared_settings(settings), .pixel = pixel};
    const FinerRays rays(scene.cameras.front(), scene.resolution);
    const Color mean = mean_color(scene, rays, pixel, context);
    log.heading("The mean of " + std::to_string(settings.pixel_samples) +
                " other rays through the pixel, which the picture has");
    log.line("color", text(mean));
    log.line("8-bit", bytes_text(to_rgb(mean, settings.gamma)));
}

}  // namespace

void explain_pixel(const Program& program, const Options& options, const Scene& scene,
                   Pixel pixel) {
    const Resolution size = scene.resolution;
    const Camera& camera = scene.cameras.front();
    TranslatedLines lines;
    std::ostream out(&lines);
    PixelLog log(out);
    log.heading(name_of(program.stage) + ", " + options.scene + ", " + size_text(size) +
                " pixels, " + name(options.precision));
    explain_screen(log, pixel, size, vertical_fov(camera, size));
    if (program.stage >= 2) explain_basis(log, camera);
    const Ray ray = pixel_rays(camera, size)(pixel);
    log.heading("The ray");
    log.line("o_r", text(ray.origin));
    log.line("d_r", text(ray.direction));
    const Watch watch{.log = &log};
    log_of_own_loop = &log;
    Context context{.settings = options.settings, .pixel = pixel, .log = &log, .watch = &watch};
    const Color color = trace(scene, ray, context);
    log_of_own_loop = nullptr;
    if (log.misses_left_out() > 0)
        log.remark(std::to_string(log.misses_left_out()) + " more shapes were missed");
    log.heading("The pixel");
    log.line("color", text(color));
    log.line("8-bit", bytes_text(to_rgb(color, options.settings.gamma)));
    if (options.settings.pixel_error > 0)
        log.remark("in the picture, a pixel beside an edge has the mean of more rays");
    else if (options.settings.pixel_samples > 1)
        log_mean(log, options.settings, scene, pixel);
}

}  // namespace rt
