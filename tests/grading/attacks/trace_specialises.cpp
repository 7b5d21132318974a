// attack: a main.cpp that specializes the library's test of a list of spheres, which others call
// ceiling: 0
// stage: step04_plane
// file: main.cpp
// compiles: no
#include "common/render/closest_hit.hpp"
#include "common/render/stage.hpp"
namespace rt {
template <>
void ClosestHit::test_list<Sphere>(const PrimitiveList<Sphere>&) {}
Color trace(const Scene&, const Ray&, Context&) {
    return Color(0);
}
}  // namespace rt
