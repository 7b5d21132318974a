// origin: invented: the new lists are left out after some reflections
// caught by: boxes and meshes are seen in a mirror, and are mirrors (CR §5.1)
// sentence: After some reflections you do not test boxes and meshes. Every ray tests all lists.
#include "common/render/closest_hit.hpp"

#include "steps/step13_meshes/meshes.hpp"

namespace rt {

class ClosestOfFewer : public ClosestHit {
public:
    ClosestOfFewer(const Ray& ray, Context& context)
        : ClosestHit(ray, context), without_boxes_(context.bounces > 1) {}

    template <class Shape>
    void test(const PrimitiveList<Shape>& primitives) {
        if (std::is_same_v<Shape, OrientedBox> && without_boxes_) return;
        ClosestHit::test(primitives);
    }

private:
    bool without_boxes_;
};

}  // namespace rt

#define ClosestHit ClosestOfFewer
#include "tests/alternatives/step13_meshes/main/own_samples.cpp"
