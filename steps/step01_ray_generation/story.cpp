#include "common/explain/pixel_log.hpp"

#include <cmath>

namespace rt {

void tell_screen(Story& story, Pixel pixel, Resolution resolution, Real vertical_fov) {
    const Real w = Real(resolution.width);
    const Real h = Real(resolution.height);
    const Vec2 norm((Real(pixel.column) + Real(0.5)) / w, (Real(pixel.row) + Real(0.5)) / h);
    const Vec2 screen(2 * norm.x - 1, 1 - 2 * norm.y);
    const Real tangent = std::tan(vertical_fov / 2);
    story.heading("The pixel on the screen (MRT §1)");
    story.line("i, j", std::to_string(pixel.row) + ", " + std::to_string(pixel.column));
    story.line("ratio = W / H", text(w / h));
    story.line("tan(FOV / 2)", text(tangent));
    story.line("pixNorm", text(norm));
    story.line("pixScreen", text(screen));
    story.line("pixFinal", text(Vec2(screen.x * (w / h) * tangent, screen.y * tangent)));
}

}  // namespace rt
