#include "docs/accuracy/chart.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace rt::accuracy {

namespace {

using figures::Anchor;
using figures::TextStyle;

constexpr Real line_height = 16;
constexpr TextStyle small{.color = figures::gray, .size = 12};

/// 0 to 1 from the scale's first value to its last.
Real share(const Scale& scale, Real value) {
    const Real all = std::log10(scale.last / scale.first);
    return std::clamp(std::log10(std::max(value, scale.first) / scale.first) / all, Real(0),
                      Real(1));
}

std::string plain(Real value) {
    char text[32];
    std::snprintf(text, sizeof text, "%g", value);
    return text;
}

}  // namespace

std::vector<Tick> decades(int first, int last, int step) {
    std::vector<Tick> ticks;
    for (int power = first; power <= last; power += step)
        ticks.push_back({std::pow(Real(10), Real(power)),
                         power == 0   ? "1"
                         : power == 1 ? "10"
                                      : "$10^{" + figures::decimal(Real(power), 0) + "}$"});
    return ticks;
}

std::vector<Tick> values(const std::vector<Real>& values) {
    std::vector<Tick> ticks;
    for (const Real value : values) ticks.push_back({value, plain(value)});
    return ticks;
}

Scale of_a_million() {
    constexpr Real none = 30;
    std::vector<Tick> ticks = decades(2, 6, 2);
    ticks.insert(ticks.begin(), {none, "0"});
    return {.first = none, .last = Real(1e6), .ticks = ticks, .title = ""};
}

Panel::Panel(Svg& svg, const Frame& frame, const Scale& x, const Scale& y)
    : svg_(svg), frame_(frame), x_(x), y_(y) {
    const Vec2 end = frame.corner + frame.size;
    for (const Tick& tick : x.ticks) {
        const Real at = (*this)({tick.value, y.first}).x;
        svg.line({at, frame.corner.y}, {at, end.y}, {.color = figures::faint, .width = 1});
        svg.text({at, end.y + 17}, tick.label, small);
    }
    for (const Tick& tick : y.ticks) {
        const Real at = (*this)({x.first, tick.value}).y;
        svg.line({frame.corner.x, at}, {end.x, at}, {.color = figures::faint, .width = 1});
    }
    svg.text({frame.corner.x + frame.size.x / 2, end.y + 36}, x.title, {.size = 13});
}

void Panel::title(std::string_view text) {
    svg_.text(frame_.corner - Vec2(0, 10), text,
              {.anchor = Anchor::start, .size = 13, .bold = true});
}

void Panel::write_y_ticks() {
    for (const Tick& tick : y_.ticks) {
        TextStyle style = small;
        style.anchor = Anchor::end;
        svg_.text((*this)({x_.first, tick.value}) + Vec2(-8, 4), tick.label, style);
    }
}

void Panel::line(const std::vector<Vec2>& points, const Pen& pen) {
    std::vector<Vec2> placed;
    for (const Vec2& point : points) placed.push_back((*this)(point));
    svg_.polyline(placed, pen);
}

void Panel::mark(Vec2 point, std::string_view color, bool filled) {
    const Vec2 place = (*this)(point);
    if (filled)
        svg_.circle(place, 5, color, {.color = figures::white, .width = 1});
    else
        svg_.circle(place, Real(4.25), figures::white, {.color = color, .width = 2});
}

Vec2 Panel::operator()(Vec2 point) const {
    return {frame_.corner.x + share(x_, point.x) * frame_.size.x,
            frame_.corner.y + (1 - share(y_, point.y)) * frame_.size.y};
}

void write_labels(Svg& svg, std::vector<Label> labels, Real x, Real top, Real bottom) {
    std::ranges::stable_sort(labels, {}, [](const Label& label) { return label.point.y; });
    std::vector<Real> heights;
    Real free = top;
    for (const Label& label : labels) {
        heights.push_back(std::max(label.point.y, free));
        free = heights.back() + line_height;
    }
    // What would stand below the bottom pushes the others up.
    Real limit = bottom;
    for (std::size_t i = heights.size(); i-- > 0;) {
        heights[i] = std::min(heights[i], limit);
        limit = heights[i] - line_height;
    }
    for (std::size_t i = 0; i < labels.size(); ++i) {
        const auto& [point, text, color] = labels[i];
        const Vec2 elbow(x - 14, heights[i]);
        svg.polyline({point, elbow, Vec2(x - 4, heights[i])}, {.color = color, .width = Real(0.6)});
        svg.text({x, heights[i] + 4}, text, {.color = color, .anchor = Anchor::start, .size = 12});
    }
}

void draw(Panel& panel, const std::vector<Series>& lines) {
    for (auto series = lines.rbegin(); series != lines.rend(); ++series)  // the first over all
        panel.line(series->points, {.color = series->color, .width = Real(1.8)});
}

void dot(Panel& panel, const std::vector<Series>& lines) {
    for (const Series& series : lines)
        for (const Vec2& point : series.points) panel.mark(point, series.color, true);
}

void name(Svg& svg, const Panel& panel, const std::vector<Series>& lines) {
    std::vector<Label> labels;
    for (const auto& [name, color, points] : lines)
        labels.push_back({panel(points.back()), name, color});
    const auto& [corner, size] = panel.frame();
    write_labels(svg, labels, corner.x + size.x + 26, corner.y + 4, corner.y + size.y);
}

}  // namespace rt::accuracy
