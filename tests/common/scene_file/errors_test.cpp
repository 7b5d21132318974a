// The errors of a wrong scene: the place, the mistake, and the expected words.

#include "tests/common/scene_file/reading.hpp"

#include "steps/step02_camera_basis/camera_basis.hpp"

#include "tests/kit/catch.hpp"

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

using namespace rt;

namespace {

struct Wrong {
    std::string line;     ///< the third of the scene
    std::string message;  ///< after "scene.rt:3:"
};

/// A folder that is gone after the test.
struct Folder {
    std::filesystem::path path =
        std::filesystem::temp_directory_path() /
        (sizeof(Real) == 4 ? "raysteps_scenes_f32" : "raysteps_scenes_f64");
    Folder() { std::filesystem::create_directories(path); }
    ~Folder() {
        std::error_code ignored;
        std::filesystem::remove_all(path, ignored);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    [[nodiscard]] std::string write(const std::string& name, const std::string& content) const {
        std::ofstream(path / name, std::ios::binary) << content;
        return (path / name).string();
    }
};

std::string load_refusal(const std::string& file) {
    try {
        static_cast<void>(load_scene(file, orthonormal_basis));
        return "accepted";
    } catch (const InputError& error) {
        return error.what();
    }
}

}  // namespace

TEST_CASE("wrong in lenient and in strict reading") {
    const std::vector<Wrong> all = {
        {"sp 0,0,0 -2 1,2,3", R"(10: error: a sphere's diameter must be positive, not "-2")"},
        {"cy 0,0,0 0,1,0 1 -1 1,2,3",
         R"(18: error: a cylinder's height must be positive, not "-1")"},
        {"tr 0,0,0 1,1 1,0,0 1,2,3",
         R"(10: error: a triangle's second corner must be three numbers as in 1,2,3, not "1,1")"},
        {"sp 1,2,3,4 1 1,2,3",
         R"(4: error: a sphere's position must be three numbers as in 1,2,3, not "1,2,3,4")"},
        {"sp 1,,3 1 1,2,3",
         R"(4: error: a sphere's position must be three numbers as in 1,2,3, not "1,,3")"},
        {"sp ,1,2 1 1,2,3",
         R"(4: error: a sphere's position must be three numbers as in 1,2,3, not ",1,2")"},
        {"sp 1;2;3 1 1,2,3",
         R"(4: error: a sphere's position must be three numbers as in 1,2,3, not "1;2;3")"},
        {"sp 0,0,0 1 255",
         R"(12: error: a sphere's color must be three numbers as in 1,2,3, not "255")"},
        {"sp 0,0,zero 1 1,2,3",
         R"(8: error: each component of a sphere's position must be a decimal number, not "zero")"},
        {"c 0,0,0",
         R"(8: error: a camera's direction is missing: expected "c position direction fov")"},
        {"sp 0,0,0 1 255 1",
         R"(12: error: a sphere's color must be three numbers as in 1,2,3, not "255")"},
        {"pl 0,0,0 0,1,0  ",
         R"(15: error: a plane's color is missing: expected "pl position normal color")"},
        {"sp",
         R"(3: error: a sphere's position is missing: expected "sp position diameter color")"},
        {"sp 0,0,0 # 1 1,2,3",
         R"(9: error: a sphere's diameter is missing: expected "sp position diameter color")"},
        {"sq 0,0,0 0,1,0 1 1,2,3 sides:3",
         R"(30: error: a square's sides must be 2 or 1, not "3")"},
        {"sq 0,0,0 0,1,0 1 1,2,3 sides:", R"(30: error: a square's sides must be 2 or 1, not "")"},
        {"sky 1,2,3", R"(10: error: the sky's top color is missing: expected "sky color color")"},
        {"sky 1,2,3 0.5",
         R"(11: error: the sky's top color must be three numbers as in 1,2,3, not "0.5")"},
        {"R 640 -1",
         R"(7: error: the resolution's height must be a positive whole number, not "-1")"},
        {"R 640x480 1",
         R"(3: error: the resolution's width must be a positive whole number, not "640x480")"},
        {"mesh my model.obj 0,0,0 1 1,2,3",
         R"(6: error: a mesh's file must have a name without blanks, not "my model.obj")"},
        {"mesh the 2 new  cats.off 0,0,0 1 1,2,3 dir:0,1,0",
         R"(6: error: a mesh's file must have a name without blanks, not "the 2 new  cats.off")"},
        {"mesh a.off 0 0 0 1 1,2,3",
         R"(12: error: a mesh's position must be three numbers as in 1,2,3, not "0")"},
        {"mesh a.off 0,0,0 1,2,3",
         R"(18: error: a mesh's scale must be a decimal number, not "1,2,3")"},
    };
    for (const Wrong& wrong : all) {
        // Lenient reading accepts a second R only there; elsewhere it is the only one.
        const bool second = wrong.line.starts_with("R");
        const std::string text =
            second ? "#\nC 0,0,0 0,0,-1 60\n" + wrong.line : with_camera(wrong.line);
        CHECK(lenient_refusal(text) == "scene.rt:3:" + wrong.message);
        CHECK(strict_refusal(text) == "scene.rt:3:" + wrong.message);
    }
}

TEST_CASE("invalid decimal numbers") {
    for (const std::string word : {"x",    "1x", "0x1p3", "0x10", "inf", "-inf",  "nan",  "NAN",
                                   ".",    "-",  "+",     "-.",   "+-1", "--1",   "1-",   "0..1",
                                   "0.1.", "1e", "1e+",   "e1",   "1_0", "1'000", "\"\"", "true"}) {
        const std::string message =
            "scene.rt:3:10: error: a sphere's diameter must be a decimal number, not " +
            (word == "\"\"" ? "\"\"\"\"" : "\"" + word + "\"");
        CHECK(lenient_refusal(with_camera("sp 0,0,0 " + word + " 1,2,3")) == message);
        CHECK(strict_refusal(with_camera("sp 0,0,0 " + word + " 1,2,3")) == message);
    }
}

TEST_CASE("numbers out of range: too large is an error, and so is a length that is lost") {
    const std::string huge(400, '9');
    CHECK(strict_refusal(with_camera("sp 0,0," + huge + " 1 1,2,3")) ==
          "scene.rt:3:8: error: each component of a sphere's position must be small enough to "
          "compute with, not \"" +
              huge.substr(0, 40) + "...\"");
    const std::string tiny = "." + std::string(400, '0') + "1";
    CHECK(lenient(camera + "sp 0,0,0 " + tiny + " 1,2,3").scene.spheres.empty());
    CHECK(strict_refusal(with_camera("sp 0,0,0 " + tiny + " 1,2,3")) ==
          "scene.rt:3:10: error: a sphere's diameter must be large enough to compute with, not \"" +
              tiny.substr(0, 40) + "...\"");
    CHECK(lenient_refusal(with_camera("sp 0,0,1e99999999999999999999 1 1,2,3")) ==
          "scene.rt:3:8: error: each component of a sphere's position must be small enough to "
          "compute with, not \"1e99999999999999999999\"");
    using Words = std::vector<std::string>;
    for (const std::string& zero : Words{"0", "-0.0", "-" + tiny})
        CHECK(strict_refusal(with_camera("sp 0,0,0 " + zero + " 1,2,3"))
                  .starts_with("scene.rt:3:10: error: a sphere's diameter must be positive, not "));
    CHECK(lenient_refusal(with_camera("sp 0,0,0 -" + tiny + " 1,2,3")) != "accepted");
    CHECK(lenient(camera + "sp 0,0,0 0e99999999999999999999 1,2,3").scene.spheres.empty());
    CHECK(lenient_refusal(with_camera("sp 0,0,0e99999999999999999999 1 1,2,3")) == "accepted");
    CHECK(lenient_refusal(with_camera("sp 0,0,1e-99999999999999999999 1 1,2,3")) == "accepted");
}

TEST_CASE("a base-anchored cylinder whose center is out of range") {
    const std::string far = sizeof(Real) == 4 ? "3e38" : "1.7e308";
    CHECK(lenient_refusal(
              with_camera("cy 0," + far + ",0 0,1,0 1 " + far + " 1,2,3 # rt: cyl=base")) ==
          "scene.rt:3:1: error: a cylinder's center is too far away");
}

TEST_CASE("ranges are judged by the digits, not by the nearest float or double") {
    const std::string above_one = "1." + std::string(100, '0') + "1";
    const std::string rule = "the ambient light's ratio must be from 0 to 1, not \"";
    CHECK(strict_refusal(with_camera("A " + above_one + " 1,2,3")) ==
          "scene.rt:3:3: error: " + rule + above_one.substr(0, 40) + "...\"");
    const std::string scientific = "1" + above_one.substr(2) + "e-101";
    CHECK(lenient(camera + "A " + scientific + " 1,2,3").warnings.at(1) ==
          "scene.rt:2:3: warning: " + rule + scientific.substr(0, 40) + "...\"; it is 1");
    const std::string nines(100, '9');
    CHECK(strict_refusal(with_camera("A 0." + nines + " 1,2,3")) == "accepted");
    CHECK(lenient_refusal("C 0,0,0 1,0,0 179." + nines) == "accepted");
    CHECK(lenient("C 0,0,0 1,0,0 18" + above_one.substr(2) + "e-100").warnings.size() == 2);
    CHECK(strict_refusal(with_camera("A 1." + std::string(100, '0') + " 1,2,3")) == "accepted");
    CHECK(strict_refusal(with_camera("A -0.0 1,2,3")) == "accepted");
    for (const std::string below_zero : {"-1e-300", "-1e-400"})  // the second rounds to −0
        CHECK(lenient(camera + "A " + below_zero + " 1,2,3").warnings.at(1) ==
              "scene.rt:2:3: warning: " + rule + below_zero + "\"; it is 0");
    CHECK(strict_refusal("C 0,0,0 1.00000000001,0,0 60") ==
          "scene.rt:1:9: error: each component of a camera's direction must be from -1 to 1, not "
          "\"1.00000000001\"");
    CHECK(lenient_refusal("C 0,0,0 1.00000000001,0,0 60") == "accepted");
    CHECK(strict_refusal("C 0,0,0 1,0,0 180.00000000001") ==
          "scene.rt:1:15: error: a camera's field of view must be from 0 to 180, not "
          "\"180.00000000001\"");
}

TEST_CASE("no camera") {
    const std::string message =
        "scene.rt: error: no camera: expected a line \"C position direction fov\"";
    for (const std::string text :
         {"", "\n \t\n", "# C 0,0,0 0,0,-1 60", "R 1 1\n", "\xEF\xBB\xBF"}) {
        CHECK(lenient_refusal(text) == message);
        CHECK(strict_refusal(text) == message);
    }
}

TEST_CASE("strict reading refuses everything that lenient reading warns of") {
    const std::vector<Wrong> all = {
        {"cu 0,0,0 1 1,2,3",
         R"(1: error: "cu" must be one of R A C c L l sky sp pl tr sq cy co box mesh)"},
        {"sp 0,0,0 1 1,2,3 x",
         R"(18: error: "x" is one word too many for a sphere: expected "sp position diameter color")"},
        {"sp 0,0,0 1 1,2,3 1 1",
         R"(18: error: "1" is the first of 2 words too many for a sphere: expected "sp position diameter color")"},
        {"sp 0,0,0 1 1,2,3 sides:1",
         R"(18: error: "sides:1" is not an option of a sphere: expected "sp position diameter color")"},
        {"sq 0,0,0 0,1,0 1 1,2,3 sides:1 sides:2",
         R"(32: error: "sides:2" repeats an option of a square: expected "sq position normal side color [sides:1|2]")"},
        {"sp 0,0,0 1 1, 2, 3",
         R"(12: error: blanks around the commas of "1, 2, 3": expected three numbers as in 1,2,3)"},
        {"sp 0,0 ,0 1 1,2,3",
         R"(4: error: blanks around the commas of "0,0 ,0": expected three numbers as in 1,2,3)"},
        {"sp 0,0,0 1 1 ,2,3",
         R"(12: error: blanks around the commas of "1 ,2,3": expected three numbers as in 1,2,3)"},
        {"cy 0,0,0 0,1,0 1 ,2,3 1 1",
         R"(16: error: blanks around the commas of "1 ,2,3": expected three numbers as in 1,2,3)"},
        {"sky 1,2,3 1 , 2 ,3",
         R"(11: error: blanks around the commas of "1 , 2 ,3": expected three numbers as in 1,2,3)"},
        {"sp 0,0,0 1 wood",
         R"(12: error: a sphere's color must be three numbers as in 1,2,3, not "wood")"},
        {"sp 0,0,0 1 0 m wood.png",
         R"(12: error: a sphere's color must be three numbers as in 1,2,3, not "0")"},
        {"c 0,0,0 0,0,1",
         R"(14: error: a camera's field of view is missing: expected "c position direction fov")"},
        {"mesh a.off 0,0,0 1 1,2,3 dir:0,0,0",
         R"(30: error: a mesh's dir must not be zero: expected a direction such as 0,1,0, not "0,0,0")"},
        {"pl 0,0,0 0,-0,0. 1,2,3",
         R"(10: error: a plane's normal must not be zero: expected a direction such as 0,1,0, not "0,-0,0.")"},
        {"sp 0,0,0 1, 1,2,3",
         R"(10: error: a sphere's diameter must be a decimal number, not "1,")"},
        {"sp 0,0,0 1 r 1,2,3", R"(12: error: "r" is in place of a sphere's color)"},
        {"sp 0,0,0 1 wall.xpm #ff8000", R"(12: error: "wall.xpm" is in place of a sphere's color)"},
        {"sp 0,0,0 1 1,2.5,3",
         R"(14: error: each component of a sphere's color must be a whole number, not "2.5")"},
        {"sp 0,0,0 1 1,2.,3",
         R"(14: error: each component of a sphere's color must be a whole number, not "2.")"},
        {"sp 0,0,0 1e1 1,2,3", R"(10: error: "1e1" has an exponent: expected a plain decimal)"},
        {"cy 0,0,0 0,2,0 1 1 1,2,3",
         R"(12: error: each component of a cylinder's direction must be from -1 to 1, not "2")"},
        {"A 1", R"(4: error: the ambient light's color is missing: expected "A ratio color")"},
        {"L 0,0,0 1",
         R"(10: error: a light's color is missing: expected "L position brightness color")"},
        {"sky 1,2,3 4,5,6 7,8,9",
         R"(17: error: "7,8,9" is one word too many for the sky: expected "sky color color")"},
        {"sky 1,2,3 4,5,6.5",
         R"(15: error: each component of the sky's top color must be a whole number, not "6.5")"},
        {"sp 0,0,0 0.0 1,2,3", R"(10: error: a sphere's diameter must be positive, not "0.0")"},
        {"sq 0,0,0 0,1,0 0 1,2,3", R"(16: error: a square's side must be positive, not "0")"},
        {"co 0,0,0 0,1,0 -0 1 1,2,3", R"(16: error: a cone's diameter must be positive, not "-0")"},
        {"sp 0,0,0 1 0,256,0",
         R"(14: error: each component of a sphere's color must be from 0 to 255, not "256")"},
        {"sp 0,0,0 1 0,-1,0",
         R"(14: error: each component of a sphere's color must be from 0 to 255, not "-1")"},
        {"A 20 1,2,3", R"(3: error: the ambient light's ratio must be from 0 to 1, not "20")"},
        {"L 0,0,0 -0.1 1,2,3", R"(9: error: a light's brightness must be from 0 to 1, not "-0.1")"},
        {"sky 1,2,256 1,2,3",
         R"(9: error: each component of the sky's bottom color must be from 0 to 255, not "256")"},
        {"c 0,0,0 0,0,1 181",
         R"(15: error: a camera's field of view must be from 0 to 180, not "181")"},
        {"box 0,0,0 0,1,0 1,0,1 1,2,3",
         R"(19: error: each component of a box's size must be positive, not "0")"},
        {"mesh a.off 0,0,0 0 1,2,3", R"(18: error: a mesh's scale must be positive, not "0")"},
        {"mesh a.off 0,0,0 1,0,0 0,0,1 30 1",
         R"(18: error: a mesh's scale must be a decimal number, not "1,0,0")"},
        {"L 0,0,0 1 1,2,3 radius:0", R"(24: error: a light's radius must be positive, not "0")"},
        {"sp 0,0,0 1 1,2,3 mirror:1.5",
         R"(25: error: a sphere's mirror must be from 0 to 1, not "1.5")"},
        {"C 0,0,0 0,0,1 60", R"(1: error: a second "C": expected one)"},
        {" R 1 1", R"(2: error: a second "R": expected one)"},
        {"# rt: fov=wide",
         R"(7: error: "fov=wide" after "# rt:" must be fov=vertical, fov=horizontal, cyl=center, cyl=base, hand=right, hand=left, up=y or up=z)"},
    };
    for (const Wrong& wrong : all) {
        CHECK(strict_refusal(with_camera(wrong.line)) == "scene.rt:3:" + wrong.message);
        INFO(wrong.line);
        CHECK(lenient_refusal(with_camera(wrong.line)) == "accepted");
    }
}

TEST_CASE("strict reading requires the R of the older dialect, whose camera is c") {
    CHECK(strict_refusal("\n c 0,0,0 0,0,-1 60\n") ==
          "scene.rt:2:2: error: \"c\" without a resolution: expected \"R width height\"");
    CHECK(lenient_refusal("\n c 0,0,0 0,0,-1 60\n") == "accepted");
}

TEST_CASE("a file of another program is recognized") {
    const std::string obj = "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    const std::string remark = " (5 of 5 lines are none of a scene: is this another format?)";
    CHECK(lenient_refusal(obj) ==
          "scene.rt: error: no camera: expected a line \"C position direction fov\"" + remark);
    CHECK(strict_refusal(obj).ends_with("cy co box mesh" + remark));
    // A foreign line may begin with a word of this format.
    CHECK(lenient_refusal("CAM 1\nlookat 0 0 0\nnewmtl a\nC white\n")
              .ends_with("not \"white\" (4 of 4 lines are none of a scene: is this another "
                         "format?)"));
    CHECK(lenient_refusal("sp 0 0 0 1 255 0 0\nc 0 0 5\n").ends_with("is this another format?)"));
    CHECK(lenient_refusal("{\"camera\": [0, 0, 5]}").ends_with("is this another format?)"));
    CHECK(lenient_refusal("C 0,0,0 0,0,-1 60\nsp 0,0,0 x\na\n").ends_with("not \"x\""));
}

TEST_CASE("a file of another program is refused by one line, without its warnings") {
    std::vector<std::string> warnings;
    const SceneReading reading{
        .warn = [&warnings](const std::string& warning) { warnings.push_back(warning); }};
    CHECK_THROWS_AS(
        parse_scene("v 0 0 0\nvn 1 0 0\nf 1 2 3\n", "a.obj", orthonormal_basis, reading),
        InputError);
    CHECK(warnings.empty());
    CHECK_THROWS_AS(
        parse_scene(camera + "cube 1\nsp 0,0,0 x\n", "a.rt", orthonormal_basis, reading),
        InputError);
    CHECK(warnings.size() == 1);
}

TEST_CASE("a mesh in place of a scene is named as such") {
    const Folder folder;
    const std::string mesh = folder.write("teapot.OBJ", "v 0 0 0\n");
    CHECK(load_refusal(mesh) == mesh +
                                    ": error: this is a mesh: name it in a scene, as in "
                                    "\"mesh teapot.OBJ 0,0,0 1 200,200,200\"");
    for (const std::string name : {"a.off", "a.ply", "a b.stl"})
        CHECK(load_refusal(folder.write(name, std::string("ply\0", 4)))
                  .find("this is a mesh: name it in a scene") != std::string::npos);
    CHECK(load_refusal((folder.path / "none.obj").string()).ends_with("no such file"));
}

TEST_CASE("a message quotes neither control characters nor long words") {
    CHECK(strict_refusal(camera + "\x1B[31m" + std::string(100, 'a')) ==
          "scene.rt:2:1: error: \"\\x1B[31m" + std::string(35, 'a') +
              "...\" must be one of R A C c L l sky sp pl tr sq cy co box mesh");
    CHECK(
        strict_refusal(camera + "sph\xC3\xA8re") ==
        "scene.rt:2:1: error: \"sph\\xC3\\xA8re\" must be one of R A C c L l sky sp pl tr sq cy co "
        "box mesh");
}

TEST_CASE("a file of anything ends its warnings after twenty") {
    std::string text = "C 0,0,0 0,0,-1 60\n";
    for (int i = 0; i < 1000; ++i) text += "word" + std::to_string(i) + "\n";
    const auto warnings = lenient(text).warnings;
    REQUIRE(warnings.size() == 21);
    CHECK(warnings.back() == "scene.rt:22:1: warning: further warnings are omitted");
}

TEST_CASE("binary files, and text of two bytes a character") {
    const std::string elf(
        "C 0,0,0 0,0,-1 60\n\x7F"
        "ELF\0\0",
        24);
    CHECK(lenient_refusal(elf) == "scene.rt:2:5: error: a zero byte: expected text");
    const std::string utf16 =
        "scene.rt:1:1: error: text in UTF-16 or UTF-32: expected UTF-8, as which an editor can "
        "save it";
    CHECK(lenient_refusal({"\xFF\xFE"
                           "C\0",
                           4}) == utf16);
    CHECK(strict_refusal({"\xFE\xFF\0C", 4}) == utf16);
}

TEST_CASE("a line that is too long to be an element") {
    const std::string first_line = "C 0,0,0 0,0,-1 60\n";
    CHECK(strict_refusal(first_line + std::string(10'000, ' ') + "\n") == "accepted");
    CHECK(lenient_refusal(first_line + std::string(10'001, ' ')) ==
          "scene.rt:2:10001: error: a line of more than 10000 bytes: expected an element");
}

TEST_CASE("load_scene reads a file") {
    const Folder folder;
    const std::string file = folder.write("good.rt", "C 1,2,3 0,0,-1 60");
    CHECK(load_scene(file, orthonormal_basis).cameras.at(0).position == Vec3(1, 2, 3));
    CHECK(load_refusal(folder.write("bad.rt", "C 1,2,3")) ==
          (folder.path / "bad.rt").string() +
              ":1:8: error: a camera's direction is missing: "
              "expected \"C position direction fov\"");
}

TEST_CASE("load_scene reports why a file cannot be read") {
    const Folder folder;
    const std::string absent = (folder.path / "absent.rt").string();
    CHECK(load_refusal(absent) == absent + ": error: no such file");
    const std::string directory = folder.path.string();
    CHECK(load_refusal(directory) == directory + ": error: is a directory: expected a file");

    const std::string closed = folder.write("closed.rt", "C 0,0,0 0,0,-1 60");
    std::filesystem::permissions(closed, std::filesystem::perms::none);
    const bool may_read_all = std::ifstream(closed).is_open();  // root, or no such permissions
    if (!may_read_all) CHECK(load_refusal(closed) == closed + ": error: cannot be read");
}

TEST_CASE("load_scene stops reading a file that is too large to be a scene") {
    const Folder folder;
    const std::string file =
        folder.write("large.rt", "C 0,0,0 0,0,-1 60\n# one line of a gigabyte");
    std::filesystem::resize_file(file, std::uintmax_t(1) << 30);  // takes no space on most disks
    CHECK(load_refusal(file) == file + ": error: larger than 16 MiB: expected a scene");
    if (std::filesystem::exists("/dev/zero")) {
        CHECK(load_refusal("/dev/zero") ==
              "/dev/zero: error: is a device or a pipe: expected a file");
    }
}
