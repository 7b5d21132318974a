#include "common/program/make_picture.hpp"

#include "common/image/png.hpp"
#include "common/image/preview.hpp"
#include "common/program/used_options.hpp"
#include "common/stages/stages.hpp"
#include "common/system/escaping.hpp"
#include "common/system/terminal.hpp"
#include "common/system/text.hpp"
#include "common/system/translation.hpp"
#include "common/tuning/wording.hpp"

#include <chrono>
#include <iostream>
#include <utility>

namespace rt {

namespace {

void report(const Rendering& rendering, const Options& options, const TimeBudget* pace,
            double seconds) {
    std::string line = one_line(options.output) + ": " + size_text(rendering.image.resolution) +
                       " pixels, " + name(options.precision) + formatted(", %.2f s, ", seconds) +
                       std::to_string(rendering.rays) + " rays";
    if (rendering.sized_light_rays > 0)
        line +=
            ", " + std::to_string(rendering.sized_light_rays) + " of them to lights with a size";
    if (pace != nullptr && pace->error() < 255)
        line += "; 99 of 100 pixels within " + number(pace->error()) +
                " of 255, according to the trials";
    print_line(tr_text(line));
    if (rendering.not_a_number == 0) return;
    const Pixel first = rendering.first_not_a_number;
    line = std::to_string(rendering.not_a_number) +
           (rendering.not_a_number == 1 ? " pixel is" : " pixels are") +
           " not a number, and shown in magenta: see --pixel " + std::to_string(first.row) + "," +
           std::to_string(first.column);
    print_line(tr_text(line));
}

/// Renders the picture, or that of the numbers of --shade, whose legend is added.
std::optional<Rendering> rendering_of(const Scene& scene, const Options& options,
                                      const RenderJob& job, std::vector<std::string>& legend) {
    if (!shows_number(options.settings.shading)) return render(scene, job);
    const auto values = pixel_values(scene, job);
    if (!values) return std::nullopt;
    ShadePicture picture = shade_picture(*values, options, scene);
    legend = std::move(picture.legend);
    Rendering rendering{.rays = values->rays, .sized_light_rays = values->sized_light_rays};
    rendering.image = std::move(picture.image);
    return rendering;
}

/// Warns if the picture has a single color, with the reason.
void warn_if_blank(const Scene& scene, const Program& program, const Options& options,
                   const Image& image) {
    if (program.stage < shapes_stage) return;
    const std::string reason = why_blank(scene, options.settings, program.stage, image);
    if (!reason.empty())
        std::cerr << tr_text(to_string(FileLocation{options.scene}) + "warning: " + reason) << '\n';
}

}  // namespace

bool make_picture(const Program& program, const Options& options, const Scene& scene,
                  TracedCenters* centers, TimeBudget* pace, const std::atomic<bool>& stop) {
    const auto start = std::chrono::steady_clock::now();
    std::vector<std::string> legend;
    std::optional<Rendering> rendering;
    {
        Progress progress(!options.quiet && errors_on_terminal(), scene.resolution.height);
        RenderJob job{.threads = options.threads,
                      .settings = options.settings,
                      .row_done = [&progress] { progress.advance(); },
                      .centers = centers != nullptr ? &centers->rendering : nullptr,
                      .stop = &stop};
        if (pace != nullptr) job.next_settings = [pace] { return pace->next(); };
        rendering = rendering_of(scene, options, job, legend);
    }
    if (!rendering) return false;
    std::vector<PngText> metadata = picture_texts(program, options, scene.resolution);
    for (const std::string& line : legend) metadata.push_back({"Legend", line});
    write_png(options.output, rendering->image, metadata,
              legend.empty() ? options.settings.gamma : Gamma::unstated);
    const std::chrono::duration<double> since_start = std::chrono::steady_clock::now() - start;
    const double seconds = since_start.count() + (centers != nullptr ? centers->seconds : 0);
    if (options.preview) print(preview(rendering->image, terminal_columns()));
    if (!options.quiet && legend.empty()) warn_if_blank(scene, program, options, rendering->image);
    if (options.quiet) return true;
    report(*rendering, options, pace, seconds);
    for (const std::string& line : legend) print_line("  " + tr_text(line));
    return true;
}

}  // namespace rt
