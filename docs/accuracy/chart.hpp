// Plots: a frame with two scales, and what stands in it.
#pragma once

#include "docs/figures/svg.hpp"

#include <string>
#include <vector>

namespace rt::accuracy {

using figures::Pen;
using figures::Svg;

struct Tick {
    Real value;
    std::string label;
};

/// A logarithmic scale.
struct Scale {
    Real first;
    Real last;
    std::vector<Tick> ticks;
    std::string title;
};

/// Ticks at 10^first, 10^(first + step), … 10^last, written as powers.
[[nodiscard]] std::vector<Tick> decades(int first, int last, int step);

/// Ticks at these values, written in full.
[[nodiscard]] std::vector<Tick> values(const std::vector<Real>& values);

struct Frame {
    Vec2 corner;  ///< the upper left one
    Vec2 size;
};

class Panel {
public:
    Panel(Svg& svg, const Frame& frame, const Scale& x, const Scale& y);

    /// Over the frame.
    void title(std::string_view text);
    /// Beside the ticks: left of the y scale's, or nothing if a neighbour has them.
    void write_y_ticks();

    void line(const std::vector<Vec2>& points, const Pen& pen);
    /// Filled, or a ring.
    void mark(Vec2 point, std::string_view color, bool filled);

    /// Where a point stands on the page; what lies outside is brought to the frame.
    [[nodiscard]] Vec2 operator()(Vec2 point) const;
    [[nodiscard]] const Frame& frame() const { return frame_; }

private:
    Svg& svg_;
    Frame frame_;
    Scale x_;
    Scale y_;
};

/// A scale of counts in a million, on which 0 has a place.
[[nodiscard]] Scale of_a_million();

/// What stands beside a point of a plot.
struct Label {
    Vec2 point;  ///< on the page
    std::string text;
    std::string_view color;
};

/// Writes the labels one below the other from x on, each as near to its point as the others let it,
/// with a line that leads to the point.
void write_labels(Svg& svg, std::vector<Label> labels, Real x, Real top, Real bottom);

/// A line of a plot.
struct Series {
    std::string name;
    std::string_view color;
    std::vector<Vec2> points;
};

/// The lines; a disc at each of their points; beside the frame, what each of them is.
void draw(Panel& panel, const std::vector<Series>& lines);
void dot(Panel& panel, const std::vector<Series>& lines);
void name(Svg& svg, const Panel& panel, const std::vector<Series>& lines);

}  // namespace rt::accuracy
