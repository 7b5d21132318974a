// origin: invented: a mirror passes the light on
// caught by: a mirror shows what another mirror shows (CR §5.1)
// sentence: A perfect mirror casts no shadow in your answer. Every shape between the point and the light hides it.
#include "common/render/closest_hit.hpp"
#include "steps/step08_cone/all_shapes.hpp"

namespace rt {

/// Stands for AnyHit, whose hit may be a mirror.
class AnyOtherHit {
public:
    AnyOtherHit(const Ray& ray, Interval interval, Context& context)
        : ray_(ray), interval_(interval), context_(context) {}

    template <class Shape>
    void test(const PrimitiveList<Shape>& primitives) {
        for (std::size_t i = 0; i < primitives.size(); ++i)
            found_ = found_ || (primitives[i].material.mirror < 1 &&
                                intersect(ray_, primitives[i].shape, interval_));
    }

    [[nodiscard]] bool found() const { return found_; }

private:
    const Ray& ray_;
    Interval interval_;
    Context& context_;
    bool found_ = false;
};

}  // namespace rt

#define AnyHit AnyOtherHit
#include "tests/alternatives/step12_mirror/main/own_samples.cpp"
