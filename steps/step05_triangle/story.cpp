#include "common/explain/pixel_log.hpp"

namespace rt {

const char* explain(PixelLog& log, const Ray& ray, const Triangle& triangle) {
    const auto& [a, b, c] = triangle;
    const Vec3 n = cross(b - a, c - a);
    const Real approach = dot(ray.direction, n);
    log.line("n = (b − a) ∧ (c − a)", text(n));
    log.line("⟨d_r, n⟩", text(approach));
    if (approach == 0) return "⟨d_r, n⟩ = 0: the triangle is seen edge-on (MRT §5)";
    const Real t = dot(a - ray.origin, n) / approach;
    const Vec3 p = at(ray, t);
    const Real side_ab = dot(cross(b - a, p - a), n);
    const Real side_bc = dot(cross(c - b, p - b), n);
    const Real side_ca = dot(cross(a - c, p - c), n);
    log.line("t", text(t));
    log.line("p", text(p));
    log.line("⟨(b − a) ∧ (p − a), n⟩", text(side_ab));
    log.line("⟨(c − b) ∧ (p − b), n⟩", text(side_bc));
    log.line("⟨(a − c) ∧ (p − c), n⟩", text(side_ca));
    log.line("α, β, γ", text(Vec3(side_bc, side_ca, side_ab) / dot(n, n)));
    if (t <= 0) return "t is not positive: the triangle is behind (MRT §5)";
    if (side_ab < 0) return "p is not on c's side of ab (MRT §5)";
    if (side_bc < 0) return "p is not on a's side of bc (MRT §5)";
    if (side_ca < 0) return "p is not on b's side of ca (MRT §5)";
    return "";
}

}  // namespace rt
