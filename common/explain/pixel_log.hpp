// The pixel log of `--pixel`: all quantities on the way of one pixel's ray, in the symbols of the
// course.
#pragma once

#include "common/explain/text.hpp"
#include "common/geometry/ray.hpp"
#include "common/scene/scene.hpp"

#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace rt {

/// Writes the pixel log, one quantity on each line.
class Story {
public:
    explicit Story(std::ostream& out) : out_(out) {}

    /// Starts a new group of lines.
    void heading(const std::string& text);
    /// "  name = value"
    void line(const std::string& name, const std::string& value);
    /// A line of text after an arrow.
    void remark(const std::string& text);

    /// Returns whether the log has room for one more missed shape: a scene may have thousands.
    [[nodiscard]] bool room_for_miss();
    /// The number of misses that were omitted.
    [[nodiscard]] int misses_left_out() const;

private:
    std::ostream& out_;
    int misses_ = 0;
};

// Each function logs the quantities by which a document decides whether the ray hits a shape. The
// shape's stage defines it (in its story.cpp) from the documents' formulas, independent of the
// stage's `intersect`. Each returns the reason for a miss; an empty string for a hit.
std::string tell(Story& story, const Ray& ray, const Sphere& sphere);
std::string tell(Story& story, const Ray& ray, const Plane& plane);
std::string tell(Story& story, const Ray& ray, const Triangle& triangle);
std::string tell(Story& story, const Ray& ray, const Square& square);
std::string tell(Story& story, const Ray& ray, const Cylinder& cylinder);
std::string tell(Story& story, const Ray& ray, const Cone& cone);
std::string tell(Story& story, const Ray& ray, const OrientedBox& box);
std::string tell(Story& story, const Ray& ray, const PlacedMesh& placed);

/// A description, "a mesh of 12 triangles, …": no C++ code that constructs the mesh.
std::string code(const PlacedMesh& placed);

/// Logs and returns the real solutions of A t² + B t + C = 0 (PHY); empty if there are none.
std::vector<Real> tell_quadratic(Story& story, Real a, Real b, Real c);

/// Log the ray through the pixel (stage 1), and its rotation by the camera (stage 2).
void tell_screen(Story& story, Pixel pixel, Resolution resolution, Real vertical_fov);
void tell_basis(Story& story, const Camera& camera);

/// Logs the closest hit: its point, and the result of the stage's `normal` there.
void tell_hit(Story& story, Vec3 point, Vec3 normal);

/// Logs the result of `intersect` for one shape, after the quantities that explain it.
template <class Shape>
void tell_candidate(Story& story, const Ray& ray, const Shape& shape, Interval interval,
                    std::optional<Real> t) {
    if (!t && !story.room_for_miss()) return;
    story.heading(code(shape));
    const std::string reason = tell(story, ray, shape);
    if (t)
        story.remark("hit at t = " + text(*t) +
                     (reason.empty() ? "" : " according to intersect, although " + reason));
    else if (!reason.empty())
        story.remark("missed: " + reason);
    else if (interval.max < infinity)
        story.remark("not nearer than the hit at t = " + text(interval.max));
    else
        story.remark("missed according to intersect, although no condition above fails");
}

}  // namespace rt
