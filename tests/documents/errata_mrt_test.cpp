// Errata of MRT: see tests/documents/errata.hpp.
#include "steps/step02_camera_basis/camera_basis.hpp"
#include "steps/step03_sphere/sphere.hpp"
#include "steps/step04_plane/plane.hpp"
#include "steps/step05_triangle/triangle.hpp"
#include "steps/step07_cylinder/cylinder.hpp"
#include "steps/step08_cone/cone.hpp"

#include "tests/documents/errata.hpp"

#include <cmath>

using namespace rt;

TEST_CASE("erratum 1: r² is subtracted in the discriminant (MRT §3)") {
    const Vec3 to_center = unit_sphere.center - five_before.origin;
    const Real along = dot(five_before.direction, to_center);
    const Real printed = 4 * (along * along - dot(to_center, to_center) - 1);
    const Real right = 4 * (along * along - dot(to_center, to_center) + 1);
    CHECK(printed == -4);
    CHECK(right == 4);
    CHECK(hits(five_before, unit_sphere, 4));
}

TEST_CASE("erratum 2: ‖d‖² is dropped before t² (MRT §3)") {
    const Ray ray{.origin = {0, 9, -15}, .direction = {0, -3, 5}};
    const Real b = 2 * dot(ray.direction, ray.origin);
    const Real c = dot(ray.origin, ray.origin) - 1;
    CHECK(dot(ray.direction, ray.direction) == 34);
    const Real t = 3 - 1 / std::sqrt(Real(34));  // one before the center, which is 3 d away
    CHECK(std::abs(34 * t * t + b * t + c) < Real(0.001));
    CHECK(std::abs(t * t + b * t + c) > 250);  // as printed, that t is not a root
    CHECK(hits(ray, unit_sphere, t));
}

TEST_CASE("erratum 3: X has not unit length (MRT §2)") {
    const Vec3 z(0, std::sqrt(Real(0.75)), Real(0.5));  // pitched by 60°
    const Vec3 printed = cross(Vec3(0, 1, 0), z);
    CHECK(close(length(printed), Real(0.5)));
    CHECK(close(length(orthonormal_basis(z).x), 1));
}

TEST_CASE("erratum 4: the cone is as wide as the root of r/h (MRT §8)") {
    const Real r = 1;
    const Real h = 2;
    CHECK(close(std::sqrt(r / h * h * h), std::sqrt(Real(2))));  // printed, at z = h: 1.414
    CHECK(close(std::sqrt(r / h * r / h * h * h), r));
    const Cone cone{.apex = {0, 0, 0}, .axis = {0, 1, 0}, .radius = r, .height = h};
    CHECK(hits(Ray{.origin = {0, 2, 5}, .direction = {0, 0, -1}}, cone, 4));
    CHECK(misses(Ray{.origin = {Real(1.25), 2, 5}, .direction = {0, 0, -1}}, cone));
}

TEST_CASE(
    "erratum 5: with strict inequalities a quad's diagonal is a crack (MRT §5–6, CR §2.3, §4.1)") {
    const Triangle lower{.a = {0, 0, 0}, .b = {4, 0, 0}, .c = {0, 4, 0}};
    const Triangle upper{.a = {4, 4, 0}, .b = {0, 4, 0}, .c = {4, 0, 0}};
    const Vec3 middle(2, 2, 0);
    for (const auto& [a, b, c] : {lower, upper}) {
        const Real side = dot(cross(c - b, middle - b), cross(c - b, a - b));
        CHECK(side == 0);  // MRT §5 requires more than 0: neither triangle contains the point
    }
    const Ray ray{.origin = {2, 2, 1}, .direction = {0, 0, -1}};
    CHECK(hits(ray, lower, 1));
    CHECK(hits(ray, upper, 1));
}

TEST_CASE("erratum 6: a is divided by, and can be 0 (MRT §7–8)") {
    const Vec3 along_axis(0, 0, 1);
    CHECK(along_axis.x * along_axis.x + along_axis.y * along_axis.y == 0);  // §7's a
    const Vec3 along_side(1, 0, 1);                                         // of a cone with r = h
    CHECK(along_side.x * along_side.x + along_side.y * along_side.y - along_side.z * along_side.z ==
          0);  // §8's a
    const Cylinder tube{.center = {0, 0, 0}, .axis = {0, 0, 1}, .radius = 1, .height = 2};
    CHECK(misses(Ray{.origin = {0, 0, -5}, .direction = along_axis}, tube));
    const Cone cone{.apex = {0, 0, 0}, .axis = {0, 0, 1}, .radius = 4, .height = 4};
    CHECK(hits(Ray{.origin = {-4, 0, 0}, .direction = along_side}, cone, 2));  // −c / b
}

TEST_CASE("erratum 22: ⟨d, n⟩ is divided by, and can be 0 (MRT §4, M1, PHY, CR eq. 3)") {
    // One above the ground and along it.
    const Ray ray{.origin = {0, 1, 0}, .direction = {1, 0, 0}};
    const Plane below{.point = {0, 0, 0}, .normal = {0, -1, 0}};
    const Real slope = dot(ray.direction, below.normal);
    CHECK(std::abs(slope) == 0);
    const Real t = dot(below.point - ray.origin, below.normal) / std::abs(slope);
    CHECK(t > 0);  // printed: the only condition is "t positive", and ∞ is
    CHECK(t == infinity);
    CHECK(misses(ray, below));
    // In the plane itself it is 0 / 0.
    CHECK(std::isnan(dot(below.point - below.point, below.normal) / slope));
    CHECK(misses(Ray{.origin = {0, 0, 0}, .direction = {1, 0, 0}}, below));
}

TEST_CASE("erratum 24: either of the two t will do, negative or not the smallest (MRT §7–8)") {
    const Cylinder tube{.center = {0, 0, 0}, .axis = {0, 0, 1}, .radius = 1, .height = 2};
    // x² + y² = 1 and |z| ≤ 1, the only condition.
    const auto printed = [](Vec3 p) { return p.x * p.x + p.y * p.y == 1 && std::abs(p.z) <= 1; };
    const Ray inside{.origin = {0, 0, 0}, .direction = {1, 0, 0}};
    CHECK(printed(at(inside, -1)));
    CHECK(printed(at(inside, 1)));
    CHECK(hits(inside, tube, 1));
    const Ray outside{.origin = {-5, 0, 0}, .direction = {1, 0, 0}};
    CHECK(printed(at(outside, 4)));
    CHECK(printed(at(outside, 6)));
    CHECK(hits(outside, tube, 4));
}

TEST_CASE("erratum 25: with Z as in its §2 the cone opens against its axis (MRT §8)") {
    const Vec3 axis(0, 1, 0);
    const Vec3 p(1, 2, 0);       // on the rim of a cone from 0 with r = 1, h = 2
    CHECK(dot(p, -axis) == -2);  // §2: Z = −c, so that not 0 ≤ z ≤ h
    CHECK(dot(p, axis) == 2);    // Z is the axis itself
    const Cone cone{.apex = {0, 0, 0}, .axis = axis, .radius = 1, .height = 2};
    CHECK(hits(Ray{.origin = {5, 1, 0}, .direction = {-1, 0, 0}}, cone, Real(4.5)));
    CHECK(misses(Ray{.origin = {5, -1, 0}, .direction = {-1, 0, 0}}, cone));
}
