// origin: invented: right for a cube only
// caught by: the normal is that of the face, not of the largest coordinate (M1)
// sentence: You take the axis along which the point is furthest from the center. On a long box that is often not its face: divide by half_size first.
#define normal(...) correct_normal(__VA_ARGS__)
#include "steps/step13_meshes/reference/meshes.cpp"
#undef normal

namespace rt {

Vec3 normal(const OrientedBox& box, Vec3 point) {
    const Vec3 p = in_frame(box.basis, point - box.center);
    const Vec3 size = abs(p);
    if (size.x >= size.y && size.x >= size.z) return std::copysign(Real(1), p.x) * box.basis.x;
    if (size.y >= size.z) return std::copysign(Real(1), p.y) * box.basis.y;
    return std::copysign(Real(1), p.z) * box.basis.z;
}

}  // namespace rt
