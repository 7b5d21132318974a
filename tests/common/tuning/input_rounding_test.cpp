// The warnings about scenes that float cannot represent: computed from the scene alone, before it
// is rendered.
#include "common/tuning/input_rounding.hpp"
#include "common/scene_file/reader.hpp"

#include "steps/step02_camera_basis/camera_basis.hpp"

#include "tests/kit/catch.hpp"
#include "tests/kit/picture.hpp"
#include "tests/kit/random.hpp"

#include <filesystem>

using namespace rt;

namespace {

/// Seen from `eye`.
Scene scene(Vec3 eye = {0, 1, 10}) {
    Scene empty;
    empty.cameras.push_back({.position = eye});
    return empty;
}

template <class Shape>
void add(PrimitiveList<Shape>& primitives, const Shape& shape) {
    primitives.push_back({.shape = shape, .material = {}});
}

const Basis upwards{.x = {0, 0, 1}, .y = {1, 0, 0}, .z = {0, 1, 0}};

Square tile(Vec3 center, Real side = 1) {
    return {.center = center, .basis = upwards, .side = side};
}

}  // namespace

TEST_CASE("no scene of scenes/ is at risk in float") {
    for (const auto& entry : std::filesystem::directory_iterator(project_file("scenes"))) {
        if (entry.path().extension() != ".rt") continue;
        INFO(entry.path());
        CHECK(risks_in_float(scene_lengths(load_scene(entry.path().string(), orthonormal_basis)))
                  .empty());
    }
}

TEST_CASE("sizes that are small beside the coordinates are lost in float") {
    for (const Real distance : {Real(0), Real(1e5), Real(1e7), Real(1e9)}) {
        Scene transformed = scene(Vec3(distance, 0, 10));
        add(transformed.spheres, {.center = {distance, 0, 0}, .radius = Real(0.5)});
        add(transformed.spheres, {.center = {distance, 5, 0}, .radius = 2});
        const SceneLengths lengths = scene_lengths(transformed);
        CHECK(lengths.smallest == 0.5);
        CHECK(lengths.largest == Approx(std::max(distance + 2, Real(10))));
        CHECK(lengths.loses_sizes(float_unit_roundoff) == (distance > 0));
        CHECK(risks_in_float(lengths).empty() == (distance == 0));
        CHECK_FALSE(lengths.loses_sizes(double(unit_roundoff)));
    }
}

TEST_CASE("one shape that reaches far puts the small ones at risk") {
    Scene ground = scene();
    add(ground.spheres, {.center = {0, -1e6, 0}, .radius = 1e6});
    add(ground.spheres, {.center = {0, 1, 0}, .radius = 1});
    CHECK_FALSE(risks_in_float(scene_lengths(ground)).empty());
}

TEST_CASE("where a plane's point is in the plane does not matter, nor does the scale") {
    Scene level = scene();
    add(level.planes, {.point = {1e8, 0, -1e8}, .normal = {0, 1, 0}});
    add(level.spheres, {.center = {0, 1, 0}, .radius = 1});
    CHECK(risks_in_float(scene_lengths(level)).empty());

    for (const Real scale : {Real(1e-12), Real(1e12)}) {
        Scene scaled = scene(scale * Vec3(0, 1, 10));
        add(scaled.planes, {.point = {}, .normal = {0, 1, 0}});
        add(scaled.spheres, {.center = {0, scale, 0}, .radius = scale});
        CHECK(risks_in_float(scene_lengths(scaled)).empty());
    }
    if (sizeof(Real) == sizeof(float)) return;  // which has no such scene
    for (const Real scale : {Real(1e-20), Real(1e20)}) {
        Scene scaled = scene(scale * Vec3(0, 1, 10));
        add(scaled.spheres, {.center = {0, scale, 0}, .radius = scale});
        CHECK(risks_in_float(scene_lengths(scaled)).size() == 1);
    }
}

TEST_CASE("double loses what float does, much later") {
    for (const auto& [distance, count] : {std::pair(0., 0U), {1e3, 0U}, {1e7, 1U}, {1e170, 2U}}) {
        const SceneLengths lengths{.largest = distance, .smallest = 1e-6};
        CHECK(risks_in_double(lengths).size() == count);
    }
    CHECK(risks_in_double({.largest = 1e-150, .smallest = 1e-160}) ==
          std::vector<std::string>{
              "the smallest shape has a size of 1e-160, whose square is out of the range of "
              "double"});
    CHECK(risks_in_double({.largest = 1e7, .smallest = 1e-6}) ==
          std::vector<std::string>{"coordinates reach 1e+07, so that surfaces in double are off by "
                                   "up to 8.9e-09, and the smallest shape has a size of 1e-06"});
}

TEST_CASE("gaps between surfaces that lie along each other are found, and lost in float if small") {
    for (const Real gap : {Real(1e-8), Real(1e-7), Real(1e-6), Real(0.01)}) {
        CAPTURE(gap);
        std::array<Scene, 8> scenes;
        scenes.fill(scene());
        add(scenes[0].squares, tile({0, 0, 0}, 4));
        add(scenes[0].squares, tile({1, gap, 0}));
        add(scenes[1].planes, {.point = {7, 0, 0}, .normal = {0, 2, 0}});
        add(scenes[1].triangles, {.a = {0, gap, 0}, .b = {1, gap, 0}, .c = {0, gap, 1}});
        add(scenes[2].planes, {.point = {7, 0, 0}, .normal = {0, 2, 0}});
        add(scenes[2].planes, {.point = {-3, gap, 0}, .normal = {0, -1, 0}});
        add(scenes[3].spheres, {.center = {1, 2, 3}, .radius = 1});
        add(scenes[3].spheres, {.center = {1, 2, 3}, .radius = 1 + gap});
        add(scenes[4].cylinders, {.center = {1, 2, 3}, .axis = {0, 1, 0}, .height = 2});
        add(scenes[4].cylinders, {.center = {1, 1, 3}, .axis = {0, 1, 0}, .radius = 1 + gap});
        add(scenes[5].cones, {.apex = {1, 2, 3}, .axis = {1, 0, 0}, .height = 1});
        add(scenes[5].cones, {.apex = {1 - gap * std::sqrt(Real(2)), 2, 3}, .axis = {1, 0, 0}});
        add(scenes[6].boxes, {.center = {0, Real(0.5) + gap, 0}});
        add(scenes[6].planes, {.point = {}, .normal = {0, 1, 0}});
        // They cross, and are further apart elsewhere, but not where one ends.
        add(scenes[7].squares, tile({0, 0, 0}, 4));
        add(scenes[7].squares,
            {.center = {},
             .basis = {.x = {1, gap / 2, 0}, .y = {0, 0, -1}, .z = {-gap / 2, 1, 0}}});
        for (std::size_t i = 0; i < scenes.size(); ++i) {
            CAPTURE(i);
            const SceneLengths lengths = scene_lengths(scenes[i]);
            const bool is_lost = gap < Real(0.001);
            CHECK(lengths.loses_gaps(float_unit_roundoff) == is_lost);
            CHECK(risks_in_float(lengths).size() == (is_lost ? 1 : 0));
            CHECK_FALSE(lengths.loses_gaps(double(unit_roundoff)));
            if (is_lost && i < 7) CHECK(lengths.gap == Approx(double(gap)).epsilon(0.01));
        }
    }
}

TEST_CASE("surfaces that coincide are no matter of float") {
    Scene both = scene();
    add(both.squares, tile({0, 0, 0}, 4));
    add(both.squares, tile({1, 0, 0}));
    CHECK(scene_lengths(both).gap == 0);
    CHECK(risks_in_float(scene_lengths(both)).empty());
}

TEST_CASE("surfaces that only touch have no gap") {
    Scene floor = scene();
    for (int i = 0; i < 8; ++i) add(floor.squares, tile({i, 0, 0}));
    add(floor.triangles, {.a = {0, 0, 5}, .b = {3, 0, 5}, .c = {0, 0, 8}});
    add(floor.triangles, {.a = {3, 0, 5}, .b = {3, 0, 8}, .c = {0, 0, 8}});
    add(floor.triangles, {.a = {3, 0, 8}, .b = {0, 0, 8}, .c = {0, 3, 8}});
    Scene standing = scene();
    add(standing.planes, {.point = {}, .normal = {0, 1, 0}});
    add(standing.spheres, {.center = {0, Real(0.1), 0}, .radius = Real(0.1)});
    add(standing.spheres, {.center = {Real(0.2), Real(0.1), 0}, .radius = Real(0.1)});
    add(standing.cylinders, {.center = {4, 1, 0}, .axis = {0, 1, 0}, .radius = 1, .height = 2});
    add(standing.cones, {.apex = {8, 1, 0}, .axis = {0, -1, 0}, .radius = 1, .height = 1});
    for (const Scene& touching : {floor, standing}) {
        CHECK(scene_lengths(touching).gap > 1);
        CHECK(risks_in_float(scene_lengths(touching)).empty());
    }
}

TEST_CASE("a scene of many shapes is examined quickly") {
    Scene many = scene();
    Random random(1);
    for (int i = 0; i < 100'000; ++i)
        add(many.spheres, {.center = random.point(1), .radius = random.between(0, 1)});
    CHECK(scene_lengths(many).largest > 0);
}
