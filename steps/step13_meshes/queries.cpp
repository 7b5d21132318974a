// The queries of rays among boxes and mesh instances, compiled once for all files that query.
#include "common/render/queries.hpp"

#include "steps/step13_meshes/mesh_instance.hpp"
#include "steps/step13_meshes/meshes.hpp"

namespace rt {
inline namespace RT_PRECISION {

template void ClosestHit::test_list(const PrimitiveList<OrientedBox>&);
template void ClosestHit::test_list(const PrimitiveList<MeshInstance>&);
template void AnyHit::test_list(const PrimitiveList<OrientedBox>&);
template void AnyHit::test_list(const PrimitiveList<MeshInstance>&);
template void PotentialOccluders::collect(const PrimitiveList<OrientedBox>&);
template void PotentialOccluders::collect(const PrimitiveList<MeshInstance>&);

}  // namespace RT_PRECISION
}  // namespace rt
