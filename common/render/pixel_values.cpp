#include "common/render/pixel_values.hpp"

#include "common/math/vector.hpp"
#include "common/system/parallel_for.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace rt {

namespace {

/// Calls visit(list, name of one of it) for each kind of shape, in their order.
template <class Visit>
void for_each_list(const Scene& scene, Visit visit) {
    std::apply([&](const auto&... kind) { (visit(scene.*kind.primitives, kind.one), ...); },
               shape_kinds);
    visit(scene.meshes, "mesh");
}

std::optional<PixelValues> sample_counts(const Scene& scene, RenderJob job) {
    PixelValues values{.resolution = scene.resolution};
    const auto width = std::size_t(scene.resolution.width);
    values.numbers.assign(width * std::size_t(scene.resolution.height), 1.0F);
    job.refined = [&values, width](Pixel pixel, int rays) {
        values.numbers[std::size_t(pixel.row) * width + std::size_t(pixel.column)] = float(rays);
    };
    const auto rendering = render(scene, job);
    if (!rendering) return std::nullopt;
    values.rays = rendering->rays;
    values.sized_light_rays = rendering->sized_light_rays;
    return values;
}

double length(const Numbers& v) {
    return std::hypot(v[0], v[1], v[2]);
}

double most_bounces(const std::vector<RayRecord>& rays) {
    int most = 0;
    for (const RayRecord& ray : rays) most = std::max(most, ray.bounces);
    return most;
}

double all_tests(const std::vector<RayRecord>& rays) {
    double all = 0;
    for (const RayRecord& ray : rays) all += double(ray.tests);
    return all;
}

}  // namespace

std::optional<int> number_of(const void* primitive, const Scene& scene) {
    std::optional<int> number;
    int before = 0;
    for_each_list(scene, [&](const auto& list, const char* /*name*/) {
        using Item = std::remove_cvref_t<decltype(list[0])>;
        const auto* const item = static_cast<const Item*>(primitive);
        const std::less<> is_before{};  // defined for pointers into different lists
        if (!list.empty() && !is_before(item, &list.front()) && !is_before(&list.back(), item))
            number = before + int(item - &list.front());
        before += int(list.size());
    });
    return number;
}

std::string name_of_shape(int number, const Scene& scene) {
    std::string text;
    for_each_list(scene, [&](const auto& list, const char* name) {
        const int count = int(list.size());
        if (0 <= number && number < count) text = name + (" " + std::to_string(number + 1));
        number -= count;
    });
    return text;
}

RayRecords trace_records(const Scene& scene, const Ray& ray, Context context) {
    RayRecords records;
    const Watch watch{.records = &records};
    context.watch = &watch;
    static_cast<void>(trace(scene, ray, context));
    return records;
}

std::optional<double> value_of(const RayRecords& records, Shading shading, const Scene& scene) {
    const std::vector<RayRecord>& rays = records.rays;
    if (rays.empty()) return std::nullopt;
    const RayRecord& eye = rays.front();
    switch (shading) {
        case Shading::depth:
            if (!eye.t) return std::nullopt;
            return std::abs(*eye.t) * length(eye.direction);
        case Shading::t:
            return eye.t;
        case Shading::id:
            if (!eye.t) return std::nullopt;
            if (const auto number = number_of(eye.shape, scene)) return double(*number);
            return std::nullopt;
        case Shading::bounces:
            if (!eye.t) return std::nullopt;
            return most_bounces(rays);
        case Shading::cost:
            return all_tests(rays);
        case Shading::color:
        case Shading::normal:
        case Shading::samples:
            break;
    }
    return std::nullopt;
}

std::optional<PixelValues> pixel_values(const Scene& scene, const RenderJob& job) {
    const Shading shading = job.settings.shading;
    if (shading == Shading::samples) return sample_counts(scene, job);
    const auto width = std::size_t(scene.resolution.width);
    const auto height = std::size_t(scene.resolution.height);
    const PixelRays pixel_ray = pixel_rays(scene.cameras.front(), scene.resolution);
    RenderSettings settings = job.settings;
    // Only the first ray counts for these, and a stage traces no other with this shading.
    if (shading == Shading::depth || shading == Shading::id || shading == Shading::t)
        settings.shading = Shading::normal;
    PixelValues values{.resolution = scene.resolution};
    values.numbers.resize(width * height);
    std::vector<std::pair<std::int64_t, std::int64_t>> rays(height);
    parallel_for(job.threads, height, job.stop, [&](std::size_t row) {
        RayRecords records;
        const Watch watch{.records = &records};
        Context context{.settings = settings, .watch = &watch};
        for (std::size_t column = 0; column < width; ++column) {
            context.pixel = {.row = int(row), .column = int(column)};
            records.rays.clear();
            static_cast<void>(trace(scene, pixel_ray(context.pixel), context));
            const auto value = value_of(records, shading, scene);
            if (value) values.numbers[row * width + column] = float(*value);
        }
        rays[row] = {context.rays, context.sized_light_rays};
        if (job.row_done) job.row_done();
    });
    if (job.is_stopped()) return std::nullopt;
    for (const auto& [all, sized] : rays) {
        values.rays += all;
        values.sized_light_rays += sized;
    }
    return values;
}

}  // namespace rt
