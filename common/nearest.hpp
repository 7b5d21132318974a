// The nearest of all the shapes that a ray meets (M1, "plusieurs objets"; CR §2.1).
#pragma once

#include "common/context.hpp"
#include "common/ray.hpp"
#include "common/scene.hpp"
#include "common/story.hpp"

namespace rt::inline RT_PRECISION {

/// Where a ray met the nearest shape.
struct Hit {
    Real t = 0;
    Vec3 point;
    Vec3 normal;  ///< outward, unit length
    const Material* material = nullptr;
};

/// Looks through lists of shapes for the smallest t. Every hit shortens the interval, so that the
/// shapes after it only answer if they are nearer; the point and the normal are worked out once,
/// for the winner. A kind of shape is looked for with `intersect` and `normal` of its own stage.
class Nearest {
public:
    Nearest(const Ray& ray, Context& context) : ray_(ray), story_(context.story) { ++context.rays; }

    template <class Shape>
    void among(const std::vector<Item<Shape>>& items) {
        for (const Item<Shape>& item : items) {
            const std::optional<Real> t = intersect(ray_, item.shape, interval_);
            if (story_ != nullptr) tell_candidate(*story_, ray_, item.shape, interval_, t);
            if (!t) continue;
            interval_.max = *t;
            winner_ = &item;
            describe_ = &describe<Shape>;
        }
    }

    /// The nearest of everything looked through so far, or nothing.
    [[nodiscard]] std::optional<Hit> hit() const {
        if (winner_ == nullptr) return std::nullopt;
        return describe_(winner_, ray_, interval_.max);
    }

private:
    template <class Shape>
    static Hit describe(const void* winner, const Ray& ray, Real t) {
        const auto& item = *static_cast<const Item<Shape>*>(winner);
        const Vec3 point = at(ray, t);
        return {.t = t,
                .point = point,
                .normal = normal(item.shape, point),
                .material = &item.material};
    }

    Ray ray_;
    Story* story_;
    Interval interval_;
    const void* winner_ = nullptr;
    Hit (*describe_)(const void*, const Ray&, Real) = nullptr;
};

}  // namespace rt::inline RT_PRECISION
