// right: the square laid on a disc without tearing it (Shirley and Chiu 1997), and the blocked
// counted
#define sample_light(...) correct_light_point(__VA_ARGS__)
#define visibility(...) correct_lit_share(__VA_ARGS__)
#include "steps/step11_soft_shadows/reference/soft_shadows.cpp"
#undef sample_light
#undef visibility

namespace rt {

Vec3 sample_light(const Light& light, Vec3 from, Vec2 sample) {
    const Real a = 2 * sample.x - 1;
    const Real b = 2 * sample.y - 1;
    if (a == 0 && b == 0) return correct_light_point(light, from, {0, 0});
    const bool wide = std::abs(a) > std::abs(b);
    const Real across = wide ? a : b;
    const Real angle = wide ? pi / 4 * b / a : pi / 2 - pi / 4 * a / b;
    const Real turns = angle / (2 * pi) + (across < 0 ? Real(0.5) : 0);
    return correct_light_point(light, from, {across * across, turns});
}

Real visibility(const ShadowRays& rays) {
    const int blocked = rays.sent - rays.reached;
    return 1 - Real(blocked) / Real(rays.sent);
}

}  // namespace rt
