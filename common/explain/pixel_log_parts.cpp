#include "common/explain/pixel_log.hpp"

#include <cmath>

namespace rt {

std::vector<Real> explain_quadratic(PixelLog& log, Real a, Real b, Real c) {
    const Real discriminant = b * b - 4 * a * c;
    log.line("A, B, C", text(a) + ", " + text(b) + ", " + text(c));
    log.line("Δ = B² − 4AC", text(discriminant));
    std::vector<Real> roots;
    if (a == 0 && b != 0) roots = {-c / b};
    if (a != 0 && discriminant >= 0) {
        const Real root = std::sqrt(discriminant);
        const Real t1 = (-b - root) / (2 * a);
        const Real t2 = (-b + root) / (2 * a);
        roots = {std::min(t1, t2), std::max(t1, t2)};
    }
    for (const Real t : roots) log.line("t", text(t));
    return roots;
}

void explain_hit(PixelLog& log, Vec3 point, Vec3 normal) {
    log.heading("The closest hit");
    log.line("p", text(point));
    log.line("n", text(normal));
}

}  // namespace rt
