// origin: thought of
// caught by: ambient light is its ratio, its color and the surface's, multiplied (CR §3.1)
// sentence: You leave out the ambient light's ratio: its color is multiplied by it.
#define ambient_term(...) correct_ambient_term(__VA_ARGS__)
#include "steps/step09_phong/reference/phong.cpp"
#undef ambient_term

namespace rt {

Color ambient_term(const ShadingPoint& surface, const Ambient& ambient) {
    return ambient.color * surface.material.color;
}

}  // namespace rt
