// The outlines of convex shapes in a picture, and the gaps between them.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <cstddef>
#include <vector>

namespace rt {

/// A point in a picture, in pixels from its corner.
using PicturePoint = glm::dvec2;

/// A point in the middle of a gap between two outlines. Lengths are in pixels.
struct Gap {
    PicturePoint middle{0};
    double width = 0;
    double length = 0;           ///< of the side of the outline beside it
    const char* kind = nullptr;  ///< of the shape beside it
};

class Outlines {
public:
    /// For a picture of this size.
    Outlines(int width, int height);

    /// Adds the convex hull of the points: the outline of one shape of this kind. Returns its
    /// width, the least distance of two parallel lines around it, or 1 if it has many corners: only
    /// a flat shape, of which there are few, may be much narrower than it is.
    double add(std::vector<PicturePoint> points, const char* kind);

    /// Points in the gaps narrower than a pixel, two or more in a pixel. A gap is measured from a
    /// point of an outline, at right angles to it, to the first outline that faces it. Outlines
    /// that touch or overlap leave none. Where an outline has nothing to face, the width is 1.
    [[nodiscard]] std::vector<Gap> gaps() const;

private:
    struct Side {
        PicturePoint start;
        PicturePoint along;    ///< unit length
        PicturePoint outward;  ///< unit length, at right angles
        double length;
        const char* kind;
        std::size_t shape;
    };

    struct Sample {
        PicturePoint at;
        std::size_t side;
        bool is_covered = false;  ///< by another shape, which touches or overlaps it
    };

    using Cells = std::vector<std::vector<Sample>>;

    void add_side(PicturePoint start, PicturePoint end, const char* kind);
    [[nodiscard]] std::size_t cell_of(PicturePoint point) const;
    /// The distance from a point of a side to the first side that faces it: negative if they
    /// overlap, and 1 if none is nearer than that.
    [[nodiscard]] double way_to_next(const Sample& sample, const Cells& cells) const;

    PicturePoint size_;
    std::vector<Side> sides_;
    Cells samples_;  ///< for each pixel
    std::size_t shapes_ = 0;
};

}  // namespace rt
