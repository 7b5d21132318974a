// Drawings in the plane, as SVG.
#pragma once

#include "common/real.hpp"

#include <string>
#include <vector>

namespace rt {

/// The few looks that figures have.
enum class Look { line, thin, dashed, ray, shape, good, bad };

/// A drawing whose coordinates are those of what it shows, x to the right and y upwards.
class Svg {
public:
    /// `left_bottom` to `right_top` is shown, `scale` pixels a unit.
    Svg(Vec2 left_bottom, Vec2 right_top, Real scale);

    void segment(Vec2 from, Vec2 to, Look look);
    void arrow(Vec2 from, Vec2 to, Look look);
    void circle(Vec2 center, Real radius, Look look);
    void polygon(const std::vector<Vec2>& corners, Look look);  ///< filled, closed
    void path(const std::vector<Vec2>& points, Look look);      ///< open
    void dot(Vec2 point, Look look);
    /// Text beside a point, moved by so many pixels, y upwards. "t_1" has an index.
    void label(Vec2 point, const std::string& text, Vec2 offset = {8, 6});

    void write(const std::string& file) const;

private:
    [[nodiscard]] std::string x(Vec2 point) const;
    [[nodiscard]] std::string y(Vec2 point) const;
    [[nodiscard]] std::string points(const std::vector<Vec2>& list) const;

    Vec2 left_bottom_;
    Vec2 size_;
    Real scale_;
    std::string body_;
};

}  // namespace rt
