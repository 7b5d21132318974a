// origin: a student's: the first face that is nearer than a tolerance
// caught by: the normal is that of the face, not of the largest coordinate (M1)
// sentence: You take the first face that is near enough: beside an edge that is the wrong one. The point is on the face for which |coordinate| / half_size is largest.
#define normal(...) correct_normal(__VA_ARGS__)
#include "steps/step13_meshes/reference/meshes.cpp"
#undef normal

namespace rt {

Vec3 normal(const OrientedBox& box, Vec3 point) {
    const Vec3 share = in_frame(box.basis, point - box.center) / box.half_size;
    if (std::abs(std::abs(share.x) - 1) < Real(0.0004))
        return std::copysign(Real(1), share.x) * box.basis.x;
    if (std::abs(std::abs(share.y) - 1) < Real(0.0004))
        return std::copysign(Real(1), share.y) * box.basis.y;
    return std::copysign(Real(1), share.z) * box.basis.z;
}

}  // namespace rt
