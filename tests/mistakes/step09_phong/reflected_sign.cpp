// origin: seen in student repositories: d − 2 ⟨d, N⟩ N with L for d
// caught by: light leaves on the other side of the normal, at the same angle (CR §3.1)
// sentence: Your R has the wrong sign: L − 2 ⟨L, N⟩ N leads into the surface. L leads to the light, so R = 2 ⟨L, N⟩ N − L.
#define reflected(...) correct_reflected(__VA_ARGS__)
#include "steps/step09_phong/reference/phong.cpp"
#undef reflected

namespace rt {

Vec3 reflected(Vec3 to_light, Vec3 normal) {
    return to_light - 2 * dot(to_light, normal) * normal;
}

}  // namespace rt
