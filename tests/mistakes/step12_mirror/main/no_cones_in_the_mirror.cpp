// origin: invented: the lists of shapes are written twice, the second time without the last one
// caught by: a mirror shows what another mirror shows (CR §5.1)
// sentence: In the mirror you do not test all lists of shapes. trace calls itself for the reflected ray, and tests the same lists.
#include "steps/step08_cone/all_shapes.hpp"

namespace rt {

template <class Query>
static void visit_most_shapes(Query& query, const Scene& scene, const Context& context) {
    if (context.bounces == 0) return visit_shapes(query, scene);
    query.test(scene.spheres);
    query.test(scene.planes);
    query.test(scene.triangles);
    query.test(scene.squares);
    query.test(scene.cylinders);
}

}  // namespace rt

#define visit_shapes(query, scene) visit_most_shapes(query, scene, context)
#include "tests/alternatives/step12_mirror/main/own_samples.cpp"
