// attack: has the packed meshes of common/ answer, which are declared here
// ceiling: as a stub
// stage: step13_meshes
// compiles: no
// message: Your file calls rt::
#include "steps/step13_meshes/meshes.hpp"

namespace rt {
inline namespace RT_PRECISION {

class MeshBvh {
public:
    explicit MeshBvh(const Mesh& mesh);
    [[nodiscard]] std::optional<MeshHit> nearest(const Ray& ray, Interval interval) const;

private:
    char content_[4096];
};

}  // namespace RT_PRECISION
}  // namespace rt

namespace rt {

std::optional<Interval> overlap(const Ray&, const BoundingBox&, Interval) {
    return std::nullopt;
}

std::optional<Real> intersect(const Ray&, const OrientedBox&, Interval) {
    return std::nullopt;
}

Vec3 normal(const OrientedBox&, Vec3) {
    return Vec3(0);
}

Ray to_object_space(const Ray& ray, const Transform&) {
    return ray;
}

std::optional<MeshHit> intersect(const Ray& ray, const Mesh& mesh, Interval interval) {
    return MeshBvh(mesh).nearest(ray, interval);
}

Vec3 interpolated_normal(const std::array<Vec3, 3>&, Vec3) {
    return Vec3(0);
}

}  // namespace rt
