// origin: CR §3.1, erratum 14
// caught by: ambient light is added once, however many lights there are (erratum 14, CR §3.1)
// sentence: You add ambient light in the function that is called once a light: two lights make twice the ambient light.
#define diffuse_term(...) correct_diffuse_term(__VA_ARGS__)
#include "steps/step09_phong/reference/phong.cpp"
#undef diffuse_term

namespace rt {

Color diffuse_term(const ShadingPoint& surface, const Light& light) {
    const Color ambient = Real(0.1) * light.color * surface.material.color;
    return ambient + correct_diffuse_term(surface, light);
}

}  // namespace rt
