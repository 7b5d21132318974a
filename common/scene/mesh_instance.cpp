#include "common/scene/mesh_instance.hpp"

#include "common/geometry/bounds.hpp"
#include "common/math/vector.hpp"

#include <utility>

namespace rt {

std::shared_ptr<const MeshGeometry> mesh_geometry(Mesh mesh) {
    MeshGeometry model{.mesh = std::move(mesh)};
    if (model.mesh.triangles.size() >= mesh_bvh_pays_from) model.packed.emplace(model.mesh);
    model.bounds = model.packed ? model.packed->bounds() : bounds(model.mesh);
    return std::make_shared<const MeshGeometry>(std::move(model));
}

BoundingBox bounds(const MeshInstance& instance) {
    const BoundingBox& model = instance.model->bounds;
    BoundingBox box;
    for (unsigned corner = 0; corner < 8; ++corner) {
        const Vec3 point((corner & 1U) != 0 ? model.max.x : model.min.x,
                         (corner & 2U) != 0 ? model.max.y : model.min.y,
                         (corner & 4U) != 0 ? model.max.z : model.min.z);
        box = merged(box, transformed(point, instance.placement));
    }
    // The margin covers at most a dozen roundings of the corners, and those of the ray's transform
    // to object space.
    const Real largest = largest_component(box);
    const Real margin = 32 * unit_roundoff * largest;
    return {.min = box.min - margin, .max = box.max + margin};
}

BoundingSphere bounding_sphere(const MeshInstance& instance) {
    return bounding_sphere(bounds(instance));
}

}  // namespace rt
