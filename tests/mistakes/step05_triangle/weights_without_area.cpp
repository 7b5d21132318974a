// origin: a student's: a guard against the division by 0
// caught by: a triangle without area has no weights: they are NaN (contract)
// sentence: You give a triangle without area the weights 0, or others. No weights are right there: leave the 0 / 0, which is NaN.
#define barycentric(...) correct_barycentric(__VA_ARGS__)
#include "steps/step05_triangle/reference/triangle.cpp"
#undef barycentric

namespace rt {

Vec3 barycentric(const Triangle& triangle, Vec3 point) {
    const Vec3 weights = correct_barycentric(triangle, point);
    return std::isnan(weights.x) ? Vec3(0) : weights;
}

}  // namespace rt
