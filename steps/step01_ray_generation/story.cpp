#include "common/explain/pixel_log.hpp"

#include <cmath>

namespace rt {

void explain_screen(PixelLog& log, Pixel pixel, Resolution resolution, Real vertical_fov) {
    const Real w = Real(resolution.width);
    const Real h = Real(resolution.height);
    const Vec2 norm((Real(pixel.column) + Real(0.5)) / w, (Real(pixel.row) + Real(0.5)) / h);
    const Vec2 screen(2 * norm.x - 1, 1 - 2 * norm.y);
    const Real tangent = std::tan(vertical_fov / 2);
    log.heading("The pixel on the screen (MRT §1)");
    log.line("i, j", std::to_string(pixel.row) + ", " + std::to_string(pixel.column));
    log.line("ratio = W / H", text(w / h));
    log.line("tan(FOV / 2)", text(tangent));
    log.line("pixNorm", text(norm));
    log.line("pixScreen", text(screen));
    log.line("pixFinal", text(Vec2(screen.x * (w / h) * tangent, screen.y * tangent)));
}

}  // namespace rt
