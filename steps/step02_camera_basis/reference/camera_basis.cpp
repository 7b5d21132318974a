#include "steps/step02_camera_basis/camera_basis.hpp"

#include "common/math/vector.hpp"

namespace rt {

Basis orthonormal_basis(Vec3 z) {
    // (0, 1, 0) × z written out: no component is a difference, so there is no cancellation near the
    // vertical, and x has no direction only if z is exactly vertical.
    const bool vertical = z.x == 0 && z.z == 0;
    Basis basis;
    basis.z = unit(z);
    basis.x = vertical ? Vec3(1, 0, 0) : unit(Vec3(z.z, 0, -z.x));
    // z × x, in which x.y is 0; the middle term adds two numbers of the same sign.
    basis.y = Vec3(basis.z.y * basis.x.z, basis.z.z * basis.x.x - basis.z.x * basis.x.z,
                   -basis.z.y * basis.x.x);
    return basis;
}

Basis camera_basis(Vec3 direction) {
    return orthonormal_basis(-direction);
}

Ray to_world(const Ray& ray, const Basis& basis, Vec3 position) {
    const auto rotated = [&basis](Vec3 v) { return v.x * basis.x + v.y * basis.y + v.z * basis.z; };
    return {.origin = position + rotated(ray.origin), .direction = rotated(ray.direction)};
}

Mat4 view_matrix(const Basis& basis, Vec3 position) {
    const Vec3 back = -Vec3(dot(basis.x, position), dot(basis.y, position), dot(basis.z, position));
    return {Vec4(basis.x.x, basis.y.x, basis.z.x, 0),  // GLM's matrices are lists of columns
            Vec4(basis.x.y, basis.y.y, basis.z.y, 0), Vec4(basis.x.z, basis.y.z, basis.z.z, 0),
            Vec4(back, 1)};
}

}  // namespace rt
