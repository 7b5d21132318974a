// The queries of rays among triangles, compiled once for the programs of all stages.
#include "common/render/queries.hpp"

#include "steps/step05_triangle/triangle.hpp"

namespace rt {
inline namespace RT_PRECISION {

template void ClosestHit::test_list(const PrimitiveList<Triangle>&);
template void AnyHit::test_list(const PrimitiveList<Triangle>&);
template void PotentialOccluders::collect(const PrimitiveList<Triangle>&);

}  // namespace RT_PRECISION

std::optional<Real> logged_intersect(const Ray& ray, const Triangle& triangle, Interval interval);
std::optional<Real> logged_intersect(const Ray& ray, const Triangle& triangle, Interval interval) {
    return logged(ray, triangle, interval);
}

}  // namespace rt
