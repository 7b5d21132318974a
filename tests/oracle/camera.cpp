#include "tests/oracle/camera.hpp"

namespace rt::oracle {

namespace {

/// The product of the matrix and the point, divided by its w.
NumberVector snapped_to(const Matrix& matrix, const std::array<Exact, 4>& point) {
    std::array<Exact, 4> product;
    for (std::size_t row = 0; row < 4; ++row)
        for (std::size_t column = 0; column < 4; ++column)
            product[row] = product[row] + matrix[row][column] * point[column];
    const Number w = product[3].number();
    return {product[0].number() / w, product[1].number() / w, product[2].number() / w};
}

}  // namespace

std::array<Number, 2> pixel_on_screen(Pixel pixel, Resolution resolution,
                                      const Exact& vertical_fov) {
    // A pixel's side on the screen, from the height of the whole; the center is half-way.
    const Number half = vertical_fov.number() / 2;
    const Number side = 2 * sin(half) / cos(half) / resolution.height;
    const Number from_middle_x = pixel.column + Number(0.5) - Number(resolution.width) / 2;
    const Number from_middle_y = Number(resolution.height) / 2 - pixel.row - Number(0.5);
    return {from_middle_x * side, from_middle_y * side};
}

NumberRay camera_ray(Pixel pixel, Resolution resolution, const Exact& vertical_fov) {
    const auto [x, y] = pixel_on_screen(pixel, resolution, vertical_fov);
    return {.origin = {}, .direction = {x, y, -1}};
}

NumberRay unprojected_ray(Pixel pixel, const Matrix& camera_to_world,
                          const Matrix& image_to_world) {
    const NumberVector start = snapped_to(camera_to_world, {0, 0, 0, 1});
    const NumberVector end =
        snapped_to(image_to_world, {pixel.column + Exact(0.5), pixel.row + Exact(0.5), 1, 1});
    return {.origin = start, .direction = end - start};
}

Basis<Number> orthonormal_basis(const ExactVector& z) {
    if (z.x.sign() == 0 && z.z.sign() == 0) {
        const Number up = z.y.sign();
        return {.x = {1, 0, 0}, .y = {0, 0, -up}, .z = {0, up, 0}};
    }
    // y is the component of the vertical orthogonal to z: z² (0, 1, 0) − z_y z.
    const ExactVector vertical{0, 1, 0};
    return {.x = unit(cross(vertical, z)), .y = unit(dot(z, z) * vertical - z.y * z), .z = unit(z)};
}

Basis<Number> camera_basis(const ExactVector& direction) {
    return orthonormal_basis(-direction);
}

ExactVector rotated(const ExactVector& v, const Basis<Exact>& basis) {
    return v.x * basis.x + v.y * basis.y + v.z * basis.z;
}

ExactVector seen(const ExactVector& point, const Basis<Exact>& basis, const ExactVector& position) {
    const ExactVector p = point - position;
    return {dot(p, basis.x), dot(p, basis.y), dot(p, basis.z)};
}

}  // namespace rt::oracle
