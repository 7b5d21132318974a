#include "common/render/render.hpp"

#include "common/math/spread_order.hpp"
#include "common/render/pixel_samples.hpp"
#include "common/render/refinement.hpp"
#include "common/system/parallel_for.hpp"

#include <numeric>
#include <utility>
#include <vector>

namespace rt {

namespace {

/// The statistics of a row.
struct Row {
    std::int64_t rays = 0;
    std::int64_t sized_light_rays = 0;
    int not_a_number = 0;
    int first_not_a_number = 0;  ///< column index

    void add(const Color& color, int column) {
        if (!is_number(color) && not_a_number++ == 0) first_not_a_number = column;
    }
    void add(const Context& context) {
        rays += context.rays;
        sized_light_rays += context.sized_light_rays;
    }
};

/// Renders one row. It has its own copy of the pixel rays, which no other code can change: in a
/// unity build (common/cmake/stage.cmake), quantities that are constant in a row are computed once.
[[gnu::flatten]] Row render_row(const Scene& scene, const PixelRays pixel_ray,
                                const RenderSettings& settings, int row, Image& image) {
    Context context{.settings = settings};
    Row result;
    for (int column = 0; column < image.resolution.width; ++column) {
        const Pixel pixel{.row = row, .column = column};
        context.pixel = pixel;
        const Color color = trace(scene, pixel_ray(pixel), context);
        result.add(color, column);
        image[pixel] = to_rgb(color, settings.gamma);
    }
    result.add(context);
    return result;
}

/// Renders one row with several rays for each pixel.
Row render_fine_row(const Scene& scene, const RenderJob& job, const RenderSettings& settings,
                    int row, Image& image) {
    const FinerRays rays(scene.cameras.front(), scene.resolution);
    Context context{.settings = shared_settings(settings)};
    Row result;
    for (int column = 0; column < image.resolution.width; ++column) {
        if (job.is_stopped()) break;
        const Pixel pixel{.row = row, .column = column};
        context.pixel = pixel;
        const Color color = mean_color(scene, rays, pixel, context);
        result.add(color, column);
        image[pixel] = to_rgb(color, settings.gamma);
    }
    result.add(context);
    return result;
}

/// The order of the rows. With a time budget, successive rows are far apart, so that every part of
/// the picture gets its share of the time. Otherwise rows are in sequence, and use data that the
/// previous row has brought into the cache.
std::vector<std::size_t> order_of(std::size_t rows, bool for_a_time) {
    if (for_a_time) return spread_order(rows);
    std::vector<std::size_t> order(rows);
    std::iota(order.begin(), order.end(), std::size_t(0));
    return order;
}

Rendering sum(Image image, const std::vector<Row>& rows) {
    Rendering result;
    result.image = std::move(image);
    for (std::size_t row = 0; row < rows.size(); ++row) {
        if (result.not_a_number == 0 && rows[row].not_a_number > 0)
            result.first_not_a_number = {.row = int(row), .column = rows[row].first_not_a_number};
        result.rays += rows[row].rays;
        result.sized_light_rays += rows[row].sized_light_rays;
        result.not_a_number += rows[row].not_a_number;
    }
    return result;
}

Rendering with_statistics(Image image) {
    Rendering result{.rays = std::int64_t(image.pixels.size())};
    for (Pixel pixel; pixel.row < image.resolution.height; ++pixel.row)
        for (pixel.column = 0; pixel.column < image.resolution.width; ++pixel.column)
            if (image[pixel] == not_a_color && result.not_a_number++ == 0)
                result.first_not_a_number = pixel;
    result.image = std::move(image);
    return result;
}

/// Adds the statistics of the rays through the centers.
void add_statistics(Rendering& result, const Rendering& centers) {
    result.rays += centers.rays;
    result.sized_light_rays += centers.sized_light_rays;
    const bool is_first =
        result.not_a_number == 0 || centers.first_not_a_number.row <= result.first_not_a_number.row;
    if (centers.not_a_number > 0 && is_first)
        result.first_not_a_number = centers.first_not_a_number;
    result.not_a_number += centers.not_a_number;
}

/// Renders more rays through the pixels where the picture of one ray a pixel has edges. Returns
/// nothing if it was stopped.
std::optional<Rendering> refine_edges(const Scene& scene, const RenderJob& job, Rendering centers) {
    const RenderSettings& settings = job.settings;
    Image& image = centers.image;
    std::vector<Row> rows(std::size_t(image.resolution.height));
    const FinerRays rays(scene.cameras.front(), scene.resolution);
    // A ray through the center is at most half a difference off what lies beside an edge.
    Refinement refinement(image.resolution, 2 * settings.pixel_error);
    parallel_for(job.threads, rows.size(), job.stop,
                 [&](std::size_t row) { refinement.compare(image, int(row)); });
    const auto refine_row = [&](std::size_t row) {
        const RenderSettings own = job.next_settings ? job.next_settings() : settings;
        const bool no_time = own.pixel_error >= 255;  // which no error exceeds
        Context context{.settings = adaptive_settings(own)};
        refinement.take(int(row), [&](Pixel pixel) {
            if (no_time || job.is_stopped()) return false;
            // A pixel that is not a number, and counted, stays so.
            if (centers.not_a_number > 0 && image[pixel] == not_a_color) return false;
            context.pixel = pixel;
            PixelSamples samples(scene, rays, pixel, context);
            const bool differ = trace_to_error(samples, own);
            const Color color = samples.mean();
            rows[row].add(color, pixel.column);
            image[pixel] = to_rgb(color, settings.gamma);
            if (job.refined) job.refined(pixel, samples.count());
            return differ;
        });
        rows[row].add(context);
    };
    bool first = true;
    std::vector<std::size_t> pending = order_of(rows.size(), job.next_settings != nullptr);
    while (!pending.empty()) {
        parallel_for(job.threads, pending.size(), job.stop, [&](std::size_t i) {
            refine_row(pending[i]);
            if (first && job.row_done) job.row_done();
        });
        if (job.is_stopped()) return std::nullopt;
        first = false;
        pending.clear();
        for (std::size_t row = 0; row < rows.size(); ++row)
            if (refinement.is_pending(int(row))) pending.push_back(row);
    }
    Rendering result = sum(std::move(image), rows);
    add_statistics(result, centers);
    return result;
}

/// Renders rows with what render_one(row, image) returns for each.
template <class RenderOne>
std::optional<Rendering> render_rows(const Scene& scene, const RenderJob& job,
                                     RenderOne render_one) {
    Image image(scene.resolution);
    std::vector<Row> rows(std::size_t(scene.resolution.height));
    const std::vector<std::size_t> order = order_of(rows.size(), job.next_settings != nullptr);
    parallel_for(job.threads, order.size(), job.stop, [&](std::size_t i) {
        rows[order[i]] = render_one(int(order[i]), image);
        if (job.row_done && job.settings.pixel_error == 0) job.row_done();
    });
    if (job.is_stopped()) return std::nullopt;
    return sum(std::move(image), rows);
}

}  // namespace

std::optional<Rendering> render_centers(const Scene& scene, const RenderJob& job) {
    const PixelRays pixel_ray = pixel_rays(scene.cameras.front(), scene.resolution);
    return render_rows(scene, job, [&](int row, Image& image) {
        return render_row(scene, pixel_ray, job.settings, row, image);
    });
}

std::optional<Rendering> render(const Scene& scene, const RenderJob& job) {
    const bool adaptive = job.settings.pixel_error > 0;
    const bool is_plain = job.settings.pixel_samples == 1 && !adaptive && !job.next_settings;
    if (job.threads == 1 && is_plain && job.settings.gamma != Gamma::srgb)
        if (auto own = picture_by_own_loop(scene)) {
            if (job.is_stopped()) return std::nullopt;
            return with_statistics(*std::move(own));
        }
    if (adaptive || is_plain) {
        auto centers = job.centers != nullptr ? std::optional(std::move(*job.centers))
                                              : render_centers(scene, job);
        return centers && adaptive ? refine_edges(scene, job, *std::move(centers))
                                   : std::move(centers);
    }
    const PixelRays pixel_ray = pixel_rays(scene.cameras.front(), scene.resolution);
    return render_rows(scene, job, [&](int row, Image& image) {
        const RenderSettings settings = job.next_settings ? job.next_settings() : job.settings;
        return settings.pixel_samples > 1 ? render_fine_row(scene, job, settings, row, image)
                                          : render_row(scene, pixel_ray, settings, row, image);
    });
}

}  // namespace rt
