// origin: invented: ambient light treated like a light at the eye
// caught by: ambient light is the same wherever the surface is, faces, or is seen from (CR §3.1)
// sentence: Your ambient term depends on the surface's direction. Ambient light is the same from all directions.
#define ambient_term(...) correct_ambient_term(__VA_ARGS__)
#include "steps/step09_phong/reference/phong.cpp"
#undef ambient_term

namespace rt {

Color ambient_term(const ShadingPoint& surface, const Ambient& ambient) {
    return dot(surface.normal, surface.to_eye) * correct_ambient_term(surface, ambient);
}

}  // namespace rt
