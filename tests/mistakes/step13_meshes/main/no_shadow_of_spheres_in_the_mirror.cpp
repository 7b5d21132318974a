// origin: invented: the lists of shapes are written twice, the second time without the first one
// caught by: boxes and meshes are seen in a mirror, and are mirrors (CR §5.1)
// sentence: In the mirror, spheres cast no shadow. What a mirror shows is in the shadow of every kind of shape, as if it were seen.
#include "common/render/closest_hit.hpp"

namespace rt {

class AnyHitOfFewer : public AnyHit {
public:
    AnyHitOfFewer(const Ray& ray, Interval interval, Context& context)
        : AnyHit(ray, interval, context), without_spheres_(context.bounces > 0) {}

    template <class Shape>
    void test(const PrimitiveList<Shape>& primitives) {
        if (std::is_same_v<Shape, Sphere> && without_spheres_) return;
        AnyHit::test(primitives);
    }

private:
    bool without_spheres_;
};

}  // namespace rt

#define AnyHit AnyHitOfFewer
#include "tests/alternatives/step13_meshes/main/own_samples.cpp"
