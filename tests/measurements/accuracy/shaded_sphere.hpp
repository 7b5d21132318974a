// The shading of a sphere by the references, beside its closed form.
#pragma once

namespace rt {

/// The largest error in levels of the pixels' centers.
struct ShadedSphere {
    double inside = 0;
    double silhouette = 0;  ///< of pixels with a neighbor whose center is beside the sphere
};

inline namespace f32 {
[[nodiscard]] ShadedSphere shaded_sphere();
}
inline namespace f64 {
[[nodiscard]] ShadedSphere shaded_sphere();
}

}  // namespace rt
