// The queries of rays among cylinders, compiled once for the programs of all stages.
#include "common/render/queries.hpp"

#include "steps/step07_cylinder/cylinder.hpp"

namespace rt {
inline namespace RT_PRECISION {

template void ClosestHit::test_list(const PrimitiveList<Cylinder>&);
template void AnyHit::test_list(const PrimitiveList<Cylinder>&);
template void PotentialOccluders::collect(const PrimitiveList<Cylinder>&);

}  // namespace RT_PRECISION

std::optional<Real> logged_intersect(const Ray& ray, const Cylinder& cylinder, Interval interval);
std::optional<Real> logged_intersect(const Ray& ray, const Cylinder& cylinder, Interval interval) {
    return logged(ray, cylinder, interval);
}

}  // namespace rt
