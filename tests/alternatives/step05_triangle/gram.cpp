// right: the weights by the products of two sides with each other and with p − a (Ericson 2005)
#define barycentric(...) correct_barycentric(__VA_ARGS__)
#include "steps/step05_triangle/reference/triangle.cpp"
#undef barycentric

namespace rt {

Vec3 barycentric(const Triangle& triangle, Vec3 point) {
    const Vec3 u = triangle.b - triangle.a;
    const Vec3 v = triangle.c - triangle.a;
    const Vec3 w = point - triangle.a;
    const Real determinant = dot(u, u) * dot(v, v) - dot(u, v) * dot(u, v);
    const Real beta = (dot(v, v) * dot(w, u) - dot(u, v) * dot(w, v)) / determinant;
    const Real gamma = (dot(u, u) * dot(w, v) - dot(u, v) * dot(w, u)) / determinant;
    return {1 - beta - gamma, beta, gamma};
}

}  // namespace rt
