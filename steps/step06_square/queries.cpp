// The queries of rays among squares, compiled once for the programs of all stages.
#include "common/render/queries.hpp"

#include "steps/step06_square/square.hpp"

namespace rt {
inline namespace RT_PRECISION {

template void ClosestHit::test_list(const PrimitiveList<Square>&);
template void AnyHit::test_list(const PrimitiveList<Square>&);
template void PotentialOccluders::collect(const PrimitiveList<Square>&);

}  // namespace RT_PRECISION

std::optional<Real> logged_intersect(const Ray& ray, const Square& square, Interval interval);
std::optional<Real> logged_intersect(const Ray& ray, const Square& square, Interval interval) {
    return logged(ray, square, interval);
}

}  // namespace rt
