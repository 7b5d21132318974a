// The contracts of stages 1 and 2, evaluated to a hundred digits.
#pragma once

#include "common/image/pixel.hpp"
#include "tests/oracle/vector.hpp"

#include <array>

namespace rt::oracle {

struct NumberRay {
    NumberVector origin;
    NumberVector direction;
};

/// A basis whose vectors have unit length to a hundred digits, or one given by floats.
template <class T>
struct Basis {
    Vector<T> x;
    Vector<T> y;
    Vector<T> z;
};

/// Rows of four.
using Matrix = std::array<std::array<Exact, 4>, 4>;

[[nodiscard]] std::array<Number, 2> pixel_on_screen(Pixel pixel, Resolution resolution,
                                                    const Exact& vertical_fov);
[[nodiscard]] NumberRay camera_ray(Pixel pixel, Resolution resolution, const Exact& vertical_fov);
[[nodiscard]] NumberRay unprojected_ray(Pixel pixel, const Matrix& camera_to_world,
                                        const Matrix& image_to_world);

[[nodiscard]] Basis<Number> orthonormal_basis(const ExactVector& z);
[[nodiscard]] Basis<Number> camera_basis(const ExactVector& direction);

/// A vector of the basis' frame, in the world's.
[[nodiscard]] ExactVector rotated(const ExactVector& v, const Basis<Exact>& basis);

/// The result of `view_matrix` for a point: its coordinates in the basis, relative to the position.
[[nodiscard]] ExactVector seen(const ExactVector& point, const Basis<Exact>& basis,
                               const ExactVector& position);

}  // namespace rt::oracle
