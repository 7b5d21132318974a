// Tests of lenient reading, with its warnings: docs/scenes.md is the source of the expected values.
#include "tests/common/scene_file/reading.hpp"

#include "tests/kit/catch.hpp"

#include <string>
#include <vector>

using namespace rt;

TEST_CASE("lenient reading warns once a kind and goes on") {
    const auto read = lenient(
        "C 0,0,0 0,0,-1 60 sr:7680\n"
        "cube 0,0,0 1 1,2,3\n"
        "sp 0,0,-5 1 1,2,3 checker 10\n"
        "sp 0,0,-6 1 1,2,3 more\n"
        "cube 1,0,0 1 1,2,3\n"
        "sp 0,0,-7 1 1,2,3 mirror-like:1\n"
        "SP 0,0,-8 1 1,2,3\n");
    CHECK(read.scene.spheres.size() == 3);
    const std::string keywords =
        "must be one of R A C c L l sky sp pl tr sq cy co box mesh; the line is ignored";
    CHECK(read.warnings ==
          std::vector<std::string>{
              "scene.rt:1:19: warning: \"sr:7680\" is not an option of a camera: "
              "expected \"C position direction fov\"; it is ignored",
              "scene.rt:2:1: warning: \"cube\" " + keywords,
              "scene.rt:3:19: warning: \"checker\" is the first of 2 words too many for a sphere: "
              "expected \"sp position diameter color\"; it is ignored",
              "scene.rt:6:19: warning: \"mirror-like:1\" is not an option of a sphere: "
              "expected \"sp position diameter color\"; it is ignored",
              "scene.rt:7:1: warning: \"SP\" " + keywords});
}

TEST_CASE("lenient reading accepts common variants") {
    const auto sphere = [](const std::string& line) {
        const Lenient read = lenient(camera + line);
        INFO(line);
        REQUIRE(read.scene.spheres.size() == 1);
        CHECK(read.warnings.size() == 1);
        CHECK(read.scene.spheres[0].shape.center == Vec3(1, 2, 3));
        CHECK(read.scene.spheres[0].shape.radius == 2);
        return read.scene.spheres[0].material.color;
    };
    const Color color(1, Real(0.2), 0);
    CHECK(sphere("sp 1, 2, 3 4 255,51,0\n") == color);
    CHECK(sphere("sp 1,2,3 4 255 ,\t51 , 0\n") == color);
    CHECK(sphere("sp 1,2,3, 4, 255,51,0,\n") == color);
    CHECK(sphere("sp 1,2,3 4 0.5 8 rough 255,51,0\n") == color);
    CHECK(sphere("sp 1,2,3 4 255.0,51.0,0.\n") == color);
    CHECK(sphere("sp 1,2,3 4e0 255,51,0\n") == color);
}

TEST_CASE("lenient reading distinguishes a color from a diameter that ends with a comma") {
    const Scene scene = lenient(camera +
                                "cy 3,0,1 0,1,0 0.6, 0.2, 200,200,200\n"
                                "cy 3,0,1 0,1,0 255, 51, 0 4 2\n")
                            .scene;
    REQUIRE(scene.cylinders.size() == 2);
    CHECK(scene.cylinders[0].shape.radius == Real(0.6) / 2);
    CHECK(scene.cylinders[0].shape.height == Real(0.2));
    CHECK(scene.cylinders[1].shape.radius == 2);
    CHECK(scene.cylinders[1].material.color == Color(1, Real(0.2), 0));
}

TEST_CASE("lenient reading takes a word in place of a color for white") {
    const auto color = [](const std::string& line) {
        const Lenient read = lenient(camera + line);
        INFO(line);
        CHECK(read.warnings.size() >= 1);
        REQUIRE(read.scene.spheres.size() == 1);
        CHECK(read.scene.spheres[0].shape.radius == 2);
        return read.scene.spheres[0].material;
    };
    for (const std::string words :
         {"wood", "./wood.png", "m  images/wood.png", "0 m \"wood\"", "checker 1 2 3",
          "wood spec:0.5", "cb:0,255,0:0,0,255", "tex:wood.png", "map:1,2,3",
          "checker(0,0,0;9,9,9)", "cb:0,9,0:0,0,9 spec:0.5"})
        CHECK(color("sp 1,2,3 4 " + words).color == Color(1));
    CHECK(color("sp 1,2,3 4 wood spec:0.5 more").specular == Real(0.5));
    CHECK(lenient(camera + "sp 1,2,3 4 wood").warnings ==
          std::vector<std::string>{
              "scene.rt:2:12: warning: \"wood\" is in place of a sphere's color; it is white"});
    for (const std::string word : {"wood", "cb:0,255,0:0,0,255", "tex:wood.png"})
        CHECK(color("sp 1,2,3 4 " + word + " 255,51,0").color == Color(1, Real(0.2), 0));
    // A wrong or missing color is still an error.
    for (const std::string words : {"", "255", "1 2 3", "255,51", "255,51 wood", "spec:0.5",
                                    "dir:1,2,3", "x,0,0", "255,0,0:0,0,255", "25:5,0,0"})
        CHECK(lenient_refusal(camera + "sp 1,2,3 4 " + words) != "accepted");
}

TEST_CASE("lenient reading takes #rrggbb for a color where the line would have none") {
    const auto color = [](const std::string& rest) {
        const Lenient read = lenient(camera + "sp 1,2,3 4 " + rest);
        INFO(rest);
        CHECK(read.warnings.size() == 1);
        REQUIRE(read.scene.spheres.size() == 1);
        return read.scene.spheres[0].material;
    };
    const Color orange(1, Real(0.2), 0);
    for (const std::string rest :
         {"#ff3300", "#F30", "#ff3300 # a comment", "#f30#008", "#f30 // 1", "\t#f30\r"})
        CHECK(color(rest).color == orange);
    CHECK(color("#fade01 spec:0.5").color == Color(250, 222, 1) / Real(255));
    CHECK(color("#fade01 spec:0.5").specular == Real(0.5));
    CHECK(lenient(camera + "sp 1,2,3 4 #ff3300").warnings ==
          std::vector<std::string>{"scene.rt:2:12: warning: a sphere's color must be three numbers "
                                   "as in 1,2,3, not \"#ff3300\"; it is 255,51,0"});

    // Words before it are skipped, as before a triple.
    for (const std::string word : {"wall.xpm", "0.5", "spec:1"}) {
        const Lenient read = lenient(camera + "sp 1,2,3 4 " + word + " #f30 spec:0.5\n");
        CHECK(read.warnings.size() == 2);
        CHECK(read.warnings.at(0) == "scene.rt:2:12: warning: \"" + word +
                                         "\" is in place of a sphere's color; it is skipped");
        CHECK(read.scene.spheres.at(0).material.color == orange);
        CHECK(read.scene.spheres.at(0).material.specular == Real(0.5));
    }
    CHECK(lenient(camera + "sky a #f30 b #00ff00\n").scene.sky->top == Color(0, 1, 0));
    CHECK(lenient(camera + "sp 1,2,3 4 wall.xpm#f30\n").scene.spheres.at(0).material.color ==
          Color(1));

    const Scene scene = lenient(camera +
                                "A 0.5 #ff3300\nL 0,1,0 0.5 #f30 radius:2\nsky #f30 #00ff00\n"
                                "cy 3,0,1 0,1,0 #f30 4 2\nmesh x.off 0,0,0 1 #f30 dir:0,1,0\n")
                            .scene;
    CHECK(scene.ambient->color == orange);
    CHECK(scene.lights.at(0).color == orange);
    CHECK(scene.lights.at(0).radius == 2);
    CHECK(scene.sky->bottom == orange);
    CHECK(scene.sky->top == Color(0, 1, 0));
    CHECK(scene.cylinders.at(0).material.color == orange);
    CHECK(scene.cylinders.at(0).shape.radius == 2);
    CHECK(scene.mesh_requests.at(0).material.color == orange);

    // Everything else after # remains a comment, and so does a color after a complete element.
    for (const std::string rest :
         {"255,51,0 #00ff00", "255,51,0#0f0", "255,51,0 #add", "255,51,0 #0f0 1"}) {
        const Lenient read = lenient(camera + "sp 1,2,3 4 " + rest);
        CHECK(read.warnings.empty());
        CHECK(read.scene.spheres.at(0).material.color == orange);
    }
    const std::string missing =
        "scene.rt:2:11: error: a sphere's color is missing: expected \"sp position diameter "
        "color\"";
    for (const std::string rest : {"# f30", "#", "#\tf30", "// #f30"})
        CHECK(lenient_refusal(camera + "sp 1,2,3 4 " + rest) == missing);
    for (const std::string word : {"#ff330", "#ff33001", "#f3", "#ff330g", "##f30", "#red"})
        CHECK(lenient_refusal(camera + "sp 1,2,3 4 " + word + " spec:1") ==
              missing + "; \"" + word + "\" starts a comment, and a color is r,g,b as in 255,0,0");
    CHECK(lenient(camera + "#f30 #123456\nA 0.5#ff3300\n").scene.ambient->color == Color(1));
}

TEST_CASE("strict reading refuses #rrggbb for a color, by one error") {
    const std::string words = " color must be three numbers as in 1,2,3, not \"#ff3300\"";
    CHECK(strict_refusal(with_camera("sp 1,2,3 4 #ff3300")) ==
          "scene.rt:3:12: error: a sphere's" + words);
    CHECK(strict_refusal(with_camera("A 0.5 #ff3300")) ==
          "scene.rt:3:7: error: the ambient light's" + words);
    CHECK(strict_refusal(with_camera("sp 1,2,3 4 255,51,0 #ff3300")) == "accepted");
}

TEST_CASE("lenient reading takes 60 degrees for a field of view that is missing") {
    const Lenient read = lenient("C 0,0,0 0,0,-1\n");
    CHECK(read.scene.cameras.at(0).fov == pi / 3);
    CHECK(read.warnings ==
          std::vector<std::string>{
              "scene.rt:1:15: warning: a camera's field of view is missing: expected "
              "\"C position direction fov\"; it is 60"});
    CHECK(lenient("C 0,0,0 0,0,-1 #60\n").warnings == read.warnings);
}

TEST_CASE("lenient reading ignores an R of which all words are key:value") {
    const Lenient read = lenient(camera + "R samples:16 depth:4\n");
    CHECK(read.scene.resolution.width == 640);
    CHECK(read.scene.resolution.height == 480);
    CHECK(read.warnings.size() == 2);
    CHECK(lenient_refusal(camera + "R samples:16 4") != "accepted");
    CHECK(lenient_refusal(camera + "R 16:4") != "accepted");
}

TEST_CASE("lenient reading ignores an R that gives no size") {
    for (const auto& [line, why] :
         {std::pair<std::string, std::string>{
              "R", "2: warning: the resolution's width is missing: expected \"R width height\""},
          {"R 420", "6: warning: the resolution's height is missing: expected \"R width height\""},
          {"R 0 480",
           "3: warning: the resolution's width must be a positive whole number, not \"0\""},
          {"R 640 00",
           "7: warning: the resolution's height must be a positive whole number, not \"00\""}}) {
        const Lenient read = lenient(camera + line);
        CHECK(read.scene.resolution.width == 640);
        CHECK(read.scene.resolution.height == 480);
        CHECK(read.warnings ==
              std::vector<std::string>{"scene.rt:2:" + why + "; the line is ignored"});
    }
    CHECK(lenient(camera + "R full screen").scene.resolution.width == 640);
}

TEST_CASE("lenient reading takes the nearest number for one out of range") {
    const Lenient read = lenient(
        "A 20 300,-1,0\n"
        "C 0,0,0 0,0,-1 181\n"
        "C 0,0,0 0,0,-1 -1e-9\n"
        "L 0,0,0 600 1,2,3\n"
        "L 0,0,0 -0.1 255,255,256\n"
        "R 10.4 0.1\n"
        "sp 0,0,0 1 0,0,0 mirror:1.5 spec:-1\n");
    CHECK(read.scene.ambient->ratio == 1);
    CHECK(read.scene.ambient->color == Color(1, 0, 0));
    CHECK(read.scene.cameras.at(0).fov > Real(3.14));
    CHECK(read.scene.cameras.at(1).fov == 0);
    CHECK(read.scene.lights.at(0).brightness == 1);
    CHECK(read.scene.lights.at(1).brightness == 0);
    CHECK(read.scene.lights.at(1).color == Color(1));
    CHECK(read.scene.resolution.width == 10);
    CHECK(read.scene.resolution.height == 1);
    CHECK(read.scene.spheres.at(0).material.mirror == 1);
    CHECK(read.scene.spheres.at(0).material.specular == 0);
    CHECK(read.warnings.at(0) ==
          "scene.rt:1:3: warning: the ambient light's ratio must be from 0 to 1, not \"20\"; it is "
          "1");
    CHECK(lenient(camera + "A 1" + std::string(320, '0') + " 255,1" + std::string(320, '0') + ",0")
              .scene.ambient->color == Color(1, 1, 0));
}

TEST_CASE("lenient reading leaves out what has no size, and only that") {
    const Lenient read = lenient(camera +
                                 "sp 0,0,0 0 1,2,3\n"
                                 "sq 0,0,0 0,1,0 0.0 1,2,3\n"
                                 "cy 0,0,0 0,1,0 0 1 1,2,3\n"
                                 "cy 0,0,0 0,1,0 1 0 1,2,3\n"
                                 "cy 0,0,0 0,1,0 1,2,3 1 -0\n"
                                 "co 0,0,0 0,1,0 1 0 1,2,3\n"
                                 "box 0,0,0 0,1,0 1,0,1 1,2,3\n"
                                 "mesh a.off 0,0,0 0 1,2,3\n"
                                 "sp 0,0,0 1 1,2,3 shin:0\n"
                                 "L 0,0,0 1 1,2,3 radius:0\n");
    CHECK(read.scene.spheres.size() == 1);
    CHECK(read.scene.spheres.at(0).material.shininess == 32);
    CHECK(read.scene.squares.size() + read.scene.cylinders.size() + read.scene.cones.size() == 0);
    CHECK(read.scene.boxes.size() + read.scene.mesh_requests.size() == 0);
    CHECK(read.scene.lights.at(0).radius == 0);
    CHECK(read.warnings.size() == 9);  // of a cylinder's height once
    CHECK(read.warnings.at(0) ==
          "scene.rt:2:10: warning: a sphere's diameter must be positive, not \"0\"; the shape is "
          "left out");
}

TEST_CASE("lenient reading ignores a mesh in another program's layout") {
    const Lenient read = lenient(camera +
                                 "mesh a.obj 30,-30,-50 0.5,-0.5,0 0,0,1 35 1\n"
                                 "mesh b.obj 0,0,0 1 1,2,3 dir:0,1,0\n");
    CHECK(read.scene.mesh_requests.size() == 1);
    CHECK(read.warnings == std::vector<std::string>{
                               "scene.rt:2:23: warning: a mesh's scale must be a decimal number, "
                               "not \"0.5,-0.5,0\"; the line is ignored"});
}

TEST_CASE("lenient reading takes light without a color for white") {
    const Lenient read = lenient(camera + "A 0.5\nL 0,1,0 0.5\n");
    CHECK(read.scene.ambient->color == Color(1));
    CHECK(read.scene.lights.at(0).color == Color(1));
    CHECK(read.warnings ==
          std::vector<std::string>{"scene.rt:2:6: warning: the ambient light's color is missing: "
                                   "expected \"A ratio color\"; it is white"});
    CHECK(lenient(camera + "A 0.5 #white\n").warnings ==
          std::vector<std::string>{"scene.rt:2:6: warning: the ambient light's color is missing: "
                                   "expected \"A ratio color\"; \"#white\" starts a comment, and "
                                   "a color is r,g,b as in 255,0,0; it is white"});
}

TEST_CASE("of several R or A the last counts in lenient reading; cameras all stay") {
    const Lenient read = lenient("R 1 2\nA 1 0,0,0\nR 3 4\nA 0.5 0,0,0\n" + camera + camera);
    CHECK(read.scene.resolution.width == 3);
    CHECK(read.scene.ambient->ratio == Real(0.5));
    CHECK(read.scene.cameras.size() == 2);
    CHECK(read.warnings ==
          std::vector<std::string>{
              "scene.rt:3:1: warning: a second \"R\": expected one; the last one counts",
              "scene.rt:4:1: warning: a second \"A\": expected one; the last one counts",
              "scene.rt:6:1: warning: a second \"C\": expected one; "
              "pictures use the first, or that of --camera N"});
}
