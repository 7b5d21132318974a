// The queries of rays among tori, compiled once for the programs of all stages.
#include "common/render/queries.hpp"

#include "steps/step14_torus/torus.hpp"

namespace rt {
inline namespace RT_PRECISION {

template void ClosestHit::test_list(const PrimitiveList<Torus>&);
template void AnyHit::test_list(const PrimitiveList<Torus>&);
template void PotentialOccluders::collect(const PrimitiveList<Torus>&);

}  // namespace RT_PRECISION
}  // namespace rt
