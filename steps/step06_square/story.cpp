#include "common/explain/pixel_log.hpp"

#include <cmath>

namespace rt {

const char* explain(PixelLog& log, const Ray& ray, const Square& square) {
    const auto& [x_axis, y_axis, normal] = square.basis;
    const Real approach = dot(ray.direction, normal);
    log.line("X, Y, Z", text(x_axis) + ", " + text(y_axis) + ", " + text(normal));
    log.line("⟨d_r, Z⟩", text(approach));
    if (approach == 0) return "⟨d_r, Z⟩ = 0: the square is seen edge-on (MRT §6)";
    if (square.one_sided && approach > 0) return "⟨d_r, Z⟩ > 0: its back is not seen (HAI)";
    const Real t = dot(square.center - ray.origin, normal) / approach;
    const Vec3 p = at(ray, t) - square.center;
    const Real x = dot(p, x_axis);
    const Real y = dot(p, y_axis);
    log.line("t", text(t));
    log.line("x = ⟨p − o, X⟩", text(x));
    log.line("y = ⟨p − o, Y⟩", text(y));
    log.line("h / 2", text(square.side / 2));
    if (t <= 0) return "t is not positive: the square is behind (MRT §6)";
    if (std::abs(x) > square.side / 2) return "|x| > h / 2 (MRT §6)";
    if (std::abs(y) > square.side / 2) return "|y| > h / 2 (MRT §6)";
    return "";
}

}  // namespace rt
