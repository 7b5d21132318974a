// The pixel log of `--pixel`: all quantities on the way of one pixel's ray, in the symbols of the
// course.
#pragma once

#include "common/explain/text.hpp"
#include "common/geometry/ray.hpp"
#include "common/scene/scene.hpp"

#include <cstdint>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace rt {

/// Writes the pixel log, one quantity on each line.
class PixelLog {
public:
    explicit PixelLog(std::ostream& out) : out_(out) {}

    /// Starts a new group of lines.
    void heading(const std::string& text);
    /// "  name = value"
    void line(const std::string& name, const std::string& value);
    /// A line of text after an arrow.
    void remark(const std::string& text);

    /// Counts a missed shape. Returns whether the log has room for it: a scene may have thousands.
    [[nodiscard]] bool count_miss();
    /// The number of misses that were omitted.
    [[nodiscard]] int misses_left_out() const;

    /// A test of a shadow ray: of an area light, only the tests of a few rays are logged.
    enum class ShadowTest { first_of_ray, later, left_out };
    [[nodiscard]] ShadowTest shadow_test(std::int64_t ray);

    /// The primitive of the latest closest hit, which may occlude its own light.
    const void* surface = nullptr;
    /// The ray's direction and the normal there, on the ray's side, which a mirror reflects.
    std::string direction;
    std::string normal;

private:
    std::ostream& out_;
    int misses_ = 0;
    std::int64_t shadow_ray_ = 0;
    int shadow_rays_ = 0;  ///< since the last heading
};

/// The log for calls of `intersect` from a student's own loop, which has no Context: null but for
/// `--pixel` of a program that logs them (common/cmake/stage.cmake).
inline PixelLog* log_of_own_loop = nullptr;

// Each `explain` logs the quantities by which a document decides whether the ray hits a shape. The
// shape's stage defines it (in its story.cpp) from the documents' formulas, independent of the
// stage's `intersect`. Each returns the reason for a miss; an empty string for a hit. The file of
// each kind of shape in common/geometry declares its own.
const char* explain(PixelLog& log, const Ray& ray, const MeshInstance& instance);

/// A description, "a mesh of 12 triangles, …": no C++ code that constructs the mesh.
std::string code(const MeshInstance& instance);

/// Logs and returns the real solutions of A t² + B t + C = 0 (PHY); empty if there are none.
std::vector<Real> explain_quadratic(PixelLog& log, Real a, Real b, Real c);

/// Log the ray through the pixel (stage 1), and its rotation by the camera (stage 2).
void explain_screen(PixelLog& log, Pixel pixel, Resolution resolution, Real vertical_fov);
void explain_basis(PixelLog& log, const Camera& camera);

/// Logs the closest hit: its point, and the result of the stage's `normal` there.
void explain_hit(PixelLog& log, Vec3 point, Vec3 normal);

/// Logs the result of `intersect` for one shape, after the quantities that explain it.
/// `without_end` repeats the call for an interval without an end, which tells a miss from a hit
/// that is not nearer.
template <class Shape, class Repeat>
void explain_candidate(PixelLog& log, const Ray& ray, const Shape& shape, Interval interval,
                       std::optional<Real> t, const Repeat& without_end) {
    if (!t && !log.count_miss()) return;
    log.heading(code(shape));
    if (interval.min != 0 || interval.max < infinity)
        log.line("interval", "(" + text(interval.min) + ", " + text(interval.max) + ")");
    const std::string reason = explain(log, ray, shape);
    if (t)
        log.remark("hit at t = " + text(*t) +
                   (reason.empty() ? "" : " according to intersect, although " + reason));
    else if (!reason.empty())
        log.remark("missed: " + reason);
    else if (const std::optional<Real> farther = without_end(); farther && *farther >= interval.max)
        log.remark("not nearer: a hit at t = " + text(*farther) +
                   ", behind the end of the interval");
    else
        log.remark("missed according to intersect, although no condition above fails");
}

}  // namespace rt
