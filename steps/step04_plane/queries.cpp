// The queries of rays among planes, compiled once for the programs of all stages.
#include "common/render/queries.hpp"

#include "steps/step04_plane/plane.hpp"

namespace rt {
inline namespace RT_PRECISION {

template void ClosestHit::test_list(const PrimitiveList<Plane>&);
template void AnyHit::test_list(const PrimitiveList<Plane>&);
template void PotentialOccluders::collect(const PrimitiveList<Plane>&);

}  // namespace RT_PRECISION

std::optional<Real> logged_intersect(const Ray& ray, const Plane& plane, Interval interval);
std::optional<Real> logged_intersect(const Ray& ray, const Plane& plane, Interval interval) {
    return logged(ray, plane, interval);
}

}  // namespace rt
