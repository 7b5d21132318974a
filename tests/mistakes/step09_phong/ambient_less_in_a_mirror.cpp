// origin: invented
// caught by: ambient light is the same wherever the surface is, faces, or is seen from (CR §3.1)
// sentence: You take the mirror's share from the ambient term. The terms do not depend on it: stage 12 mixes their sum with the reflection.
#define ambient_term(...) correct_ambient_term(__VA_ARGS__)
#include "steps/step09_phong/reference/phong.cpp"
#undef ambient_term

namespace rt {

Color ambient_term(const ShadingPoint& surface, const Ambient& ambient) {
    return (1 - surface.material.mirror) * correct_ambient_term(surface, ambient);
}

}  // namespace rt
