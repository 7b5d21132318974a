// The ray in a mesh's frame, against M1 (change of frame) and HAI (transforms).
#include "steps/step13_meshes/meshes.hpp"

#include "tests/kit/shape_checks.hpp"

using namespace rt;

TEST_CASE("a mesh that is moved: the ray is moved the other way (HAI, translate)",
          "[part frames (to_object_space)]") {
    const Ray seen =
        to_object_space({.origin = {1, 2, 8}, .direction = {0, 1, -1}}, {.translation = {1, 2, 3}});
    CHECK(gives("to_object_space(…).origin of 1,2,8, with the mesh at 1,2,3", seen.origin,
                Vec3(0, 0, 5)));
    CHECK(gives("to_object_space(…).direction of 0,1,-1, with the mesh at 1,2,3", seen.direction,
                Vec3(0, 1, -1)));
}

TEST_CASE("a mesh twice as large: the ray and its direction are halved (HAI, scale)") {
    const Ray seen = to_object_space({.origin = {2, 0, 8}, .direction = {0, 1, -1}}, {.scale = 2});
    CHECK(gives("to_object_space(…).origin of 2,0,8, with the mesh scaled by 2", seen.origin,
                Vec3(1, 0, 4)));
    CHECK(gives("to_object_space(…).direction of 0,1,-1, with the mesh scaled by 2", seen.direction,
                Vec3(0, Real(0.5), Real(-0.5))));
}

TEST_CASE("a mesh that is turned: the ray is turned the other way (HAI, rotate)") {
    // A quarter turn around z: the mesh's x axis is the scene's y.
    const Basis quarter{.x = {0, 1, 0}, .y = {-1, 0, 0}, .z = {0, 0, 1}};
    const Ray seen =
        to_object_space({.origin = {0, 5, 1}, .direction = {1, 0, 0}}, {.rotation = quarter});
    CHECK(gives("to_object_space(…).origin of 0,5,1, with x turned to y", seen.origin,
                Vec3(5, 0, 1)));
    CHECK(gives("to_object_space(…).direction of 1,0,0, with x turned to y", seen.direction,
                Vec3(0, -1, 0)));
}

TEST_CASE("a mesh is scaled, then turned, then moved, and the ray all that backwards (HAI)") {
    const Basis quarter{.x = {0, 1, 0}, .y = {-1, 0, 0}, .z = {0, 0, 1}};
    const Transform placement{.rotation = quarter, .scale = 2, .translation = {1, 2, 3}};
    const Ray seen = to_object_space({.origin = {1, 12, 5}, .direction = {0, -4, 0}}, placement);
    CHECK(gives("to_object_space(…).origin of 1,12,5, for " + code(placement), seen.origin,
                Vec3(5, 0, 1)));
    CHECK(gives("to_object_space(…).direction of 0,-4,0, for " + code(placement), seen.direction,
                Vec3(-2, 0, 0)));
}

TEST_CASE("every point of the ray keeps its t in the mesh's frame (M1, change of frame)") {
    CHECK(for_all([](Random& random) {
        const Transform placement = random_motion(random);
        const Ray expected{.origin = random.point(4), .direction = random.direction()};
        const Ray asked = transformed(expected, placement);
        const Ray got = to_object_space(asked, placement);
        return verdict(
            close(got.origin, expected.origin) && close(got.direction, expected.direction),
            "to_object_space(" + code(asked) + ",\n           " + code(placement) +
                ")\n  got:      " + code(got) + "\n  expected: " + code(expected));
    }));
}
