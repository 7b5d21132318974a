// The queries of rays among spheres, compiled once for the programs of all stages.
#include "common/render/queries.hpp"

#include "steps/step03_sphere/sphere.hpp"

namespace rt {
inline namespace RT_PRECISION {

template void ClosestHit::test_list(const PrimitiveList<Sphere>&);
template void AnyHit::test_list(const PrimitiveList<Sphere>&);
template void PotentialOccluders::collect(const PrimitiveList<Sphere>&);

}  // namespace RT_PRECISION

std::optional<Real> logged_intersect(const Ray& ray, const Sphere& sphere, Interval interval);
std::optional<Real> logged_intersect(const Ray& ray, const Sphere& sphere, Interval interval) {
    return logged(ray, sphere, interval);
}

}  // namespace rt
