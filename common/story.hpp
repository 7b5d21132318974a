// `--pixel`: the whole story of one pixel's ray, in the symbols of the course.
#pragma once

#include "common/ray.hpp"
#include "common/scene.hpp"
#include "common/text.hpp"

#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace rt {

/// Writes the story down, one quantity a line.
class Story {
public:
    explicit Story(std::ostream& out) : out_(out) {}

    void heading(const std::string& text);
    /// "  name = value"
    void line(const std::string& name, const std::string& value);
    void remark(const std::string& text);

    /// Whether there is room for one more shape that was missed: a scene may have thousands.
    [[nodiscard]] bool room_for_miss();
    /// How many misses were left out, at the end.
    [[nodiscard]] int misses_left_out() const;

private:
    std::ostream& out_;
    int misses_ = 0;
};

// The quantities by which a document decides whether the ray meets a shape, told by the shape's
// stage (its story.cpp) from the documents' formulas, whatever the stage's `intersect` does. Each
// returns why the ray misses; nothing if it meets the shape.
std::string tell(Story& story, const Ray& ray, const Sphere& sphere);
std::string tell(Story& story, const Ray& ray, const Plane& plane);
std::string tell(Story& story, const Ray& ray, const Triangle& triangle);
std::string tell(Story& story, const Ray& ray, const Square& square);
std::string tell(Story& story, const Ray& ray, const Cylinder& cylinder);
std::string tell(Story& story, const Ray& ray, const Cone& cone);
std::string tell(Story& story, const Ray& ray, const OrientedBox& box);
std::string tell(Story& story, const Ray& ray, const PlacedMesh& placed);

/// "a mesh of 12 triangles, …": no C++ that makes it again.
std::string code(const PlacedMesh& placed);

/// The solutions of A t² + B t + C = 0 (PHY), as numbers of the story; none if they are not real.
std::vector<Real> tell_quadratic(Story& story, Real a, Real b, Real c);

/// How stage 1 makes the ray, and how stage 2 turns it.
void tell_screen(Story& story, Pixel pixel, Resolution resolution, Real vertical_fov);
void tell_basis(Story& story, const Camera& camera);

/// The nearest hit: its point, and what the stage's `normal` answers there.
void tell_hit(Story& story, Vec3 point, Vec3 normal);

/// What `intersect` answered for one shape, after the quantities that explain it.
template <class Shape>
void tell_candidate(Story& story, const Ray& ray, const Shape& shape, Interval interval,
                    std::optional<Real> t) {
    if (!t && !story.room_for_miss()) return;
    story.heading(code(shape));
    const std::string reason = tell(story, ray, shape);
    if (t)
        story.remark("hit at t = " + text(*t) +
                     (reason.empty() ? "" : ", says intersect, though " + reason));
    else if (!reason.empty())
        story.remark("missed: " + reason);
    else if (interval.max < infinity)
        story.remark("not nearer than the hit at t = " + text(interval.max));
    else
        story.remark("missed, says intersect, though nothing above does");
}

}  // namespace rt
