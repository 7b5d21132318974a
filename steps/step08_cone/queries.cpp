// The queries of rays among cones, compiled once for the programs of all stages.
#include "common/render/queries.hpp"

#include "steps/step08_cone/cone.hpp"

namespace rt {
inline namespace RT_PRECISION {

template void ClosestHit::test_list(const PrimitiveList<Cone>&);
template void AnyHit::test_list(const PrimitiveList<Cone>&);
template void PotentialOccluders::collect(const PrimitiveList<Cone>&);

}  // namespace RT_PRECISION

std::optional<Real> logged_intersect(const Ray& ray, const Cone& cone, Interval interval);
std::optional<Real> logged_intersect(const Ray& ray, const Cone& cone, Interval interval) {
    return logged(ray, cone, interval);
}

}  // namespace rt
