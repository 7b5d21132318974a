// origin: invented: ‖n‖ for ‖n‖²
// caught by: the weights give the point back, and sum to 1 (M1, CR §4.1)
// sentence: You divide ⟨(c − b) ∧ (p − b), n⟩ by ‖n‖. It contains n twice: divide by ‖n‖².
#define barycentric(...) correct_barycentric(__VA_ARGS__)
#include "steps/step05_triangle/reference/triangle.cpp"
#undef barycentric

namespace rt {

Vec3 barycentric(const Triangle& triangle, Vec3 point) {
    const auto& [a, b, c] = triangle;
    return correct_barycentric(triangle, point) * length(cross(b - a, c - a));
}

}  // namespace rt
