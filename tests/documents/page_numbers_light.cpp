// The numbers of the pages on light, shadows and mirrors.
#include "common/program/load_meshes.hpp"
#include "common/render/stage.hpp"
#include "common/scene_file/reader.hpp"

#include "steps/step02_camera_basis/camera_basis.hpp"
#include "steps/step04_plane/plane.hpp"
#include "steps/step05_triangle/triangle.hpp"
#include "steps/step09_phong/phong.hpp"
#include "steps/step10_shadows/shadows.hpp"
#include "steps/step11_soft_shadows/soft_shadows.hpp"
#include "steps/step12_mirror/mirror.hpp"

#include "tests/documents/page_numbers.hpp"
#include "tests/kit/picture.hpp"

#include <algorithm>
#include <array>

namespace rt {

Knowledge stage9() {
    const Vec3 n(0, 0, 1);
    const Vec3 l = normalize(Vec3(4, 0, -3));
    CHECK(std::isnan(std::pow(-0.5, 2.5)));
    Knowledge all = {{"where a cosine is 0", std::acos(0) / degree, "°"},
                     {"a power between 2 and 3", (2 + 3) / 2.0},
                     {"L", l.x},
                     {"L", l.z},
                     {"⟨R, V⟩", dot(reflected(l, n), -l)},
                     {"a step of the picture", 1 / 255.0},
                     {"the float behind 1", std::nextafter(1.0F, 2.0F)}};
    for (const double exponent : {2, 8, 32, 128, 512})
        all.push_back({"where the highlight is below one level",
                       std::acos(std::pow(255, -1 / exponent)) / degree, "°"});
    for (const double exponent : {2, 32, 512})
        all.push_back({"where the highlight is half as bright",
                       std::acos(std::pow(2, -1 / exponent)) / degree, "°"});
    return all;
}

Knowledge stage10() {
    const std::string source = "common/geometry/projection.hpp";
    const double flat_is_off =
        said_in("steps/step10_shadows/reference/shadows.cpp", "is hit up to ", " units off");
    // The ray's end before a light at distance 1, in units of u.
    const ShadingPoint floor{
        .point = {0, 0, 0}, .normal = {0, 1, 0}, .geometric_normal = {0, 1, 0}};
    const double before =
        (1 - double(shadow_ray(floor, {0, 1, 0}).interval.max)) / double(unit_roundoff);
    const double too_large =
        said_in("tests/common/render/contact_test.cpp", "{\"0", " along the normal\"");
    return {{"the least t (CR §3.2)", cr_shadow_start},
            {"u by which a point is off", said_in(source, "error of a point is at most ", ",")},
            {"where the ray ends before the ceiling, in whole degrees",
             std::ceil(std::asin(flat_is_off / before) / degree), "°"},
            {"the largest of the constants", too_large},
            {"half of it", too_large / 2}};
}

Knowledge stage12() {
    const Real m = Real(0.9);
    const int depth = RenderSettings().depth;
    const Real share = Real(0.1);
    CHECK(worth_reflecting(0, depth, share * share));
    CHECK_FALSE(worth_reflecting(0, depth, share * share * share));
    const float large = 1000000;
    CHECK(std::nextafter(large, 2 * large) - large > float(cr_mirror_start));
    return {{"the least t (CR §5.1)", cr_mirror_start},
            {"a scene too large for it", large},
            {"a mirror's share", share},
            {"after three reflections", share * share * share},
            {"the share of facing mirrors", m},
            {"what they show", 100 * (1 - std::pow(m, depth + 1)), "%"},
            {"the rest", 100 * std::pow(m, depth + 1), "%"}};
}

}  // namespace rt
