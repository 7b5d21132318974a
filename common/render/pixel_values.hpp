// Numbers of each pixel, which --shade shows as colors: how far its ray goes, what it hits, and
// what it costs.
#pragma once

#include "common/explain/ray_records.hpp"
#include "common/image/pixel.hpp"
#include "common/render/context.hpp"
#include "common/render/render.hpp"
#include "common/render/stage.hpp"

#include <optional>
#include <string>
#include <vector>

namespace rt {

/// A number for each pixel, in rows from the top. Empty where there is none: the ray hits nothing.
struct PixelValues {
    Resolution resolution;
    std::vector<std::optional<float>> numbers;
    std::int64_t rays = 0;
    std::int64_t sized_light_rays = 0;
};

/// The numbers that the shading of the job's settings shows, for the rays through the centers of
/// the pixels; for Shading::samples, those of the picture with these settings. Returns nothing if
/// it was stopped. The result is the same for any number of threads.
[[nodiscard]] std::optional<PixelValues> pixel_values(const Scene& scene, const RenderJob& job);

/// Traces the ray through a pixel's center, and returns its records and those of all rays that it
/// causes.
[[nodiscard]] RayRecords trace_records(const Scene& scene, const Ray& ray, Context context);

/// The number that a shading shows of these rays: for Shading::id the shape's number, from 0.
[[nodiscard]] std::optional<double> value_of(const RayRecords& records, Shading shading,
                                             const Scene& scene);

/// A shape's number among all of the scene, in the order of scene.hpp, from 0; nothing for an
/// address that is no primitive of the scene.
[[nodiscard]] std::optional<int> number_of(const void* primitive, const Scene& scene);

/// "sphere 2" for the second one of its kind in the scene.
[[nodiscard]] std::string name_of_shape(int number, const Scene& scene);

}  // namespace rt
