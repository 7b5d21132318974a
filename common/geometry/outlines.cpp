#include "common/geometry/outlines.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace rt {

namespace {

double cross(PicturePoint a, PicturePoint b) {
    return a.x * b.y - a.y * b.x;
}

/// The convex hull (Andrew's monotone chain), with its inside at the left of each side.
std::vector<PicturePoint> convex_hull(std::vector<PicturePoint> points) {
    std::ranges::sort(points, {}, [](PicturePoint point) { return std::pair(point.x, point.y); });
    std::vector<PicturePoint> hull;
    for (int half = 0; half < 2; ++half) {
        const std::size_t first = hull.size();
        for (const PicturePoint& point : points) {
            while (hull.size() > first + 1 &&
                   cross(hull.back() - hull.end()[-2], point - hull.back()) <= 0)
                hull.pop_back();
            hull.push_back(point);
        }
        hull.pop_back();  // it begins the other half
        std::ranges::reverse(points);
    }
    return hull;
}

double width_of(const std::vector<PicturePoint>& hull) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const PicturePoint side = hull[(i + 1) % hull.size()] - hull[i];
        double most = 0;
        for (const PicturePoint& point : hull) most = std::max(most, cross(side, point - hull[i]));
        least = std::min(least, most / glm::length(side));
    }
    return least;
}

}  // namespace

Outlines::Outlines(int width, int height)
    : size_(width, height), samples_(std::size_t(width) * std::size_t(height)) {}

double Outlines::add(std::vector<PicturePoint> points, const char* kind) {
    constexpr std::size_t many = 16;
    if (points.size() < 2) return 1;
    const std::vector<PicturePoint> hull = convex_hull(std::move(points));
    for (std::size_t i = 0; i < hull.size(); ++i)
        add_side(hull[i], hull[(i + 1) % hull.size()], kind);
    ++shapes_;
    return hull.size() < many ? width_of(hull) : 1;
}

void Outlines::add_side(PicturePoint start, PicturePoint end, const char* kind) {
    constexpr double apart = 0.5;
    constexpr std::size_t enough = 24;  // samples in a pixel
    const double length = glm::distance(start, end);
    if (!(length > 0)) return;
    const PicturePoint along = (end - start) / length;
    double first = 0;  // the part in the picture
    double last = length;
    for (const int axis : {0, 1}) {
        if (along[axis] == 0) continue;
        const double low = -start[axis] / along[axis];
        const double high = (size_[axis] - start[axis]) / along[axis];
        first = std::max(first, std::min(low, high));
        last = std::min(last, std::max(low, high));
    }
    const double count = std::ceil((last - first) / apart);
    for (double i = 0; i < count; ++i) {
        const PicturePoint place = start + (first + (last - first) * (i + 0.5) / count) * along;
        const std::size_t cell = cell_of(place);
        if (cell < samples_.size() && samples_[cell].size() < enough)
            samples_[cell].push_back({.at = place, .side = sides_.size()});
    }
    sides_.push_back({start, along, {along.y, -along.x}, length, kind, shapes_});
}

std::size_t Outlines::cell_of(PicturePoint point) const {
    const PicturePoint cell = glm::floor(point);
    const bool is_inside = 0 <= cell.x && cell.x < size_.x && 0 <= cell.y && cell.y < size_.y;
    return is_inside ? std::size_t(cell.y) * std::size_t(size_.x) + std::size_t(cell.x)
                     : samples_.size();
}

double Outlines::way_to_next(const Sample& sample, const Cells& cells) const {
    constexpr double facing = -0.5;  // cosine of the angle between the directions outward
    constexpr double widest_overlap = 0.5;
    const Side& side = sides_[sample.side];
    double least = 1;
    for (int i = 0; i < 9; ++i) {
        const std::size_t cell = cell_of(sample.at + PicturePoint(i % 3 - 1, i / 3 - 1));
        if (cell == cells.size()) continue;
        for (const Sample& other : cells[cell]) {
            const Side& next = sides_[other.side];
            const double turn = glm::dot(side.outward, next.outward);
            if (next.shape == side.shape || turn > facing || other.is_covered) continue;
            const double way = glm::dot(next.outward, next.start - sample.at) / turn;
            const double place = glm::dot(next.along, sample.at + way * side.outward - next.start);
            if (way > -widest_overlap && 0 <= place && place <= next.length)
                least = std::min(least, way);
        }
    }
    return least;
}

std::vector<Gap> Outlines::gaps() const {
    constexpr double touching = 0.001;  // pixels
    Cells open = samples_;
    for (std::vector<Sample>& samples : open)
        for (Sample& sample : samples) sample.is_covered = way_to_next(sample, samples_) < touching;
    std::vector<Gap> all;
    for (const std::vector<Sample>& samples : open)
        for (const Sample& sample : samples) {
            if (sample.is_covered) continue;
            const Side& side = sides_[sample.side];
            const double width = way_to_next(sample, open);
            all.push_back({.middle = sample.at + (width < 1 ? width / 2 : 0) * side.outward,
                           .width = width,
                           .length = side.length,
                           .kind = side.kind});
        }
    return all;
}

}  // namespace rt
