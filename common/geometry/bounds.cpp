#include "common/geometry/bounds.hpp"

#include "common/geometry/shape_formulas.hpp"
#include "common/math/vector.hpp"

namespace rt {

BoundingBox bounds(const Mesh& mesh) {
    BoundingBox box;
    for (const auto& triangle : mesh.triangles)
        for (const std::uint32_t vertex : triangle) box = merged(box, mesh.vertices[vertex]);
    return box;
}

BoundingSphere bounding_sphere(const BoundingBox& box) {
    const Vec3 center = box.min / Real(2) + box.max / Real(2);
    return geometry::padded(BoundingSphere{.center = center, .radius = length(box.max - center)});
}

}  // namespace rt
