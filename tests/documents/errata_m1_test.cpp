// Errata of M1: see tests/documents/errata.hpp.
#include "steps/step01_ray_generation/ray_generation.hpp"
#include "steps/step03_sphere/sphere.hpp"
#include "steps/step05_triangle/triangle.hpp"

#include "tests/documents/errata.hpp"

#include <algorithm>

using namespace rt;

TEST_CASE("erratum 7: a corner gets the area beside it (M1)") {
    const Triangle triangle{.a = {0, 0, 0}, .b = {4, 0, 0}, .c = {0, 4, 0}};
    // At p = a the triangle opposite to a is everything, the one opposite to b nothing.
    const Real area_opposite_a = length(cross(triangle.c - triangle.b, triangle.a - triangle.b));
    const Real area_opposite_b = length(cross(triangle.a - triangle.c, triangle.a - triangle.c));
    const Real area = length(cross(triangle.b - triangle.a, triangle.c - triangle.a));
    CHECK(area_opposite_b / area == 0);  // printed: α = A_b / A, which makes α a + β b + γ c = b
    CHECK(close(area_opposite_a / area, 1));
    CHECK(gives("the weights at a", barycentric(triangle, triangle.a), Vec3(1, 0, 0)));
}

TEST_CASE("erratum 8: a box behind the camera is hit (M1)") {
    // The box of side 2 around (0, 0, 5), and a ray from 0 along −z.
    const Vec3 o(0, 0, 0);
    const Vec3 d(0, 0, -1);
    Real t_min = -infinity;
    Real t_max = infinity;
    for (int i = 0; i < 3; ++i) {
        const Real middle = i == 2 ? 5 : 0;
        const auto [near, far] =
            std::minmax({(middle - 1 - o[i]) / d[i], (middle + 1 - o[i]) / d[i]});
        t_min = std::max(t_min, near);
        t_max = std::min(t_max, far);
    }
    CHECK(t_min == -6);
    CHECK(t_max == -4);
    CHECK(t_min < t_max);    // printed: a hit
    CHECK_FALSE(t_max > 0);  // the missing condition
}

TEST_CASE("erratum 26: the end point is not divided by its w, nor a pixel's center (M1)") {
    // A camera at (0, 6, 0) in the direction −z with a field of 90°, near plane 1, far plane 3.
    Mat4 view(1);
    view[3] = {0, -6, 0, 1};
    Mat4 projection(0);
    projection[0][0] = 1;
    projection[1][1] = 1;
    projection[2] = {0, 0, -2, -1};
    projection[3] = {0, 0, -3, 0};
    const Vec4 end(1, 2, -1, Real(1) / 3);  // the product of the inverse of P V and (1, 0, 1, 1)
    const Vec4 there = projection * view * end;
    CHECK(close(Vec3(there), Vec3(1, 0, 1)));
    CHECK(close(there.w, 1));
    // Divided by w it is the right end of the far plane; undivided it is another point.
    CHECK(close(Vec3(end) / end.w, Vec3(3, 6, -3)));
    const Vec4 printed = projection * view * Vec4(Vec3(end), 1);
    CHECK(close(Vec3(printed) / printed.w, Vec3(1, -4, -1)));
    // x = 0 is the left edge of the image, −1; the center of the first of four pixels is not.
    CHECK(2 * Real(0) / 4 - 1 == -1);
    CHECK(gives("the first of four pixels", pixel_on_screen({}, {.width = 4, .height = 4}, pi / 2),
                Vec2(Real(-0.75), Real(0.75))));
}

TEST_CASE("erratum 27: the torch's light is negative on surfaces that face away (M1)") {
    const Vec3 normal(0, 0, -2);
    const Vec3 to_eye(0, 0, 3);
    CHECK(dot(normal, to_eye) / (length(normal) * length(to_eye)) == -1);  // printed: cos θ
    CHECK(torch({0, 0, 0}, normal, to_eye) == 0);
}
