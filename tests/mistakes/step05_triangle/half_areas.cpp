// origin: CR §4.1: the factor ½ of one area only
// caught by: the weights give the point back, and sum to 1 (M1, CR §4.1)
// sentence: You halve the parts but not the whole: the weights sum to ½.
#define barycentric(...) correct_barycentric(__VA_ARGS__)
#include "steps/step05_triangle/reference/triangle.cpp"
#undef barycentric

namespace rt {

Vec3 barycentric(const Triangle& triangle, Vec3 point) {
    return correct_barycentric(triangle, point) / Real(2);
}

}  // namespace rt
