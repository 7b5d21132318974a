// Marks, written and read: whole, or not at all.
#include "common/course/grade/results/results.hpp"

#include "common/course/grade/results/sha256.hpp"
#include "common/system/files.hpp"
#include "common/system/hash.hpp"
#include "common/system/input_error.hpp"
#include "common/system/version.hpp"

#include "tests/grading/reports_class.hpp"
#include "tests/kit/catch.hpp"

#include <fstream>

namespace rt::grade {

namespace {

void write(const std::filesystem::path& file, const std::string& text) {
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << text;
}

/// The text with `expected` replaced by `got`, once.
std::string changed(std::string text, const std::string& expected, const std::string& got) {
    const std::size_t at = text.find(expected);
    REQUIRE(at != std::string::npos);
    return text.replace(at, expected.size(), got);
}

}  // namespace

TEST_CASE("results replace no file of the lecturer's, and are not among the submissions") {
    const Results results;
    CHECK_NOTHROW(check_results_folder(results.folder, {}));
    CHECK_NOTHROW(check_results_folder(results.folder / "new", {results.folder}));
    CHECK_THROWS_AS(check_results_folder(results.folder / ".", {results.folder}), InputError);
    write(results.folder / "term.txt", "anonymous: yes");
    CHECK_THROWS_AS(check_results_folder(results.folder / "term.txt", {}), InputError);
    CHECK_NOTHROW(check_results_folder(results.folder, {}));
    write(results.folder / "grades.csv", "student,oral exam");
    CHECK_THROWS_AS(check_results_folder(results.folder, {}), InputError);
    write(results.folder / "seed.txt", "0123456789abcdef");
    CHECK_NOTHROW(check_results_folder(results.folder, {}));
}

TEST_CASE("a mark is a file of lines: the stage's results, then one case per line") {
    const Results results;
    Mark mark{.student = "anna",
              .stage = 5,
              .key = "k",
              .verdict = Verdict::judged,
              .source = "8",
              .trace_source = "9",
              .cases = {{.name = "edges", .points = 2, .passed = true, .given = true}},
              .picture = PictureMark{.pixels = 12, .different = 3, .file = "p.png"},
              .most = 2};
    write_mark(results.folder, mark);
    CHECK(mark_file("results", "anna", 5) == "results/students/anna/step05_triangle.jsonl");
    CHECK(
        read_text(mark_file(results.folder, "anna", 5)) ==
        R"({"raysteps":1,"student":"anna","stage":5,"key":"k","verdict":"judged","words":"",)"
        R"("source":"8","trace_source":"9","mistake":"","smallest":"","slice":"","most":2,"cases":1,)"
        R"("picture":{"pixels":12,"different":3,"file":"p.png"}})"
        "\n"
        R"({"name":"edges","points":2,"passed":true,"given":true,"trace":false,"place":"",)"
        R"("words":""})"
        "\n");
}

TEST_CASE("a mark that is read is the one that was written, but for bytes that are no UTF-8") {
    const Results results;
    for (const Mark& mark : class_of_two()) write_mark(results.folder, mark);
    const std::vector<Mark> marks = read_marks(results.folder);
    REQUIRE(marks.size() == 4);
    const Mark& first = marks[0];
    CHECK(first.student == odd);
    CHECK(first.stage == 4);
    CHECK(first.key == "k4");
    CHECK(first.verdict == Verdict::judged);
    CHECK(first.words == "warning: <unused>");
    CHECK(first.source == "17");
    CHECK(first.mistake == "You compare with <0>.");
    CHECK(first.smallest == "intersect(…)\n  got: 1\n");
    CHECK(first.slice == "step04 slice.svg");
    CHECK(first.most == 2);
    CHECK(first.points() == 1);
    REQUIRE(first.cases.size() == 2);
    CHECK(first.cases[0].name == "it is hit");
    CHECK(first.cases[0].passed);
    CHECK_FALSE(first.cases[0].given);
    CHECK(first.cases[1].given);
    CHECK(first.cases[1].points == 1);
    CHECK_FALSE(first.cases[1].passed);
    CHECK(first.cases[1].place == "tests/suites/step04_plane_test.cpp:9");
    CHECK(first.cases[1].words == "got: ��(\nexpected: <hit>\n");
    REQUIRE(first.picture);
    CHECK(first.picture->pixels == 12);
    CHECK(first.picture->different == 5);
    CHECK(first.picture->file == "step04_plane.png");
    CHECK(marks[1].verdict == Verdict::refused);
    CHECK_FALSE(marks[1].picture);
    CHECK(marks[2].student == "zoe");
    CHECK(marks[2].verdict == Verdict::missing);
    CHECK(marks[2].points() == 0);
    CHECK(marks[3].points() == 3);
}

TEST_CASE("a change of a mark is listed with its reason, and nothing else is") {
    const Results results;
    const auto grade = [&](int points, const std::string& key, const std::string& source) {
        write_mark(results.folder, {.student = "=anna",
                                    .stage = 5,
                                    .key = key,
                                    .verdict = Verdict::judged,
                                    .source = source,
                                    .cases = {{.points = points, .passed = true}}});
    };
    grade(2, "1", "a");
    grade(2, "2", "b");  // other work, the same points
    CHECK_FALSE(std::filesystem::exists(results.folder / changes_file));
    grade(3, "3", "b");
    grade(1, "4", "c");
    const std::uintmax_t size = size_of_changes(results.folder);
    grade(0, "", "");
    grade(4, "5", "c");
    grade(0, "6", "");
    const std::string text = read_text(results.folder / changes_file);
    const std::string line = "\r\n" + today() + ",'=anna,step05_triangle,";
    CHECK(text == "date,student,stage,before,after,why" + line +
                      "2,3,\"the same files: the suite, a reference or the seed has changed\"" +
                      line + "3,1,triangle.cpp is another" + line +
                      "1,0,\"could not be graded; it will be judged again\"" + line +
                      "0,4,could not be graded before" + line + "4,0,triangle.cpp is missing\r\n");
    CHECK(changes_since(results.folder, 0).size() == 5);
    CHECK(changes_since(results.folder, size).size() == 3);
    CHECK(changes_since(results.folder, size).back().ends_with("4,0,triangle.cpp is missing"));
}

TEST_CASE("a mark that others have is missed, if it is damaged too") {
    const Results results;
    for (const Mark& mark : class_of_two()) write_mark(results.folder, mark);
    CHECK(missing_marks(results.folder, read_marks(results.folder)).empty());
    write_text(mark_file(results.folder, "zoe", 5), "{");
    std::filesystem::create_directories(student_folder(results.folder, "yan"));
    CHECK(missing_marks(results.folder, read_marks(results.folder)) ==
          std::vector<std::string>{"yan has no mark for step04_plane",
                                   "yan has no mark for step05_triangle",
                                   "zoe has no mark for step05_triangle"});
}

TEST_CASE("the starter's cases are worth points once any other case passes") {
    Mark mark{.cases = {{.points = 2, .passed = true, .given = true}, {.points = 3}}};
    CHECK(mark.points() == 0);
    mark.cases[1].passed = true;
    CHECK(mark.points() == 5);
    mark.cases[0].passed = false;
    CHECK(mark.points() == 3);
}

TEST_CASE("a student's name may be any bytes that a folder may have") {
    const Results results;
    const std::string name = "\xff\xfe";
    write_mark(results.folder, {.student = name, .stage = 1, .key = "k"});
    const std::optional<Mark> mark = read_mark(results.folder, name, 1);
    REQUIRE(mark);
    CHECK(mark->student == name);
    for (const std::string& bad : {std::string(), std::string("."), std::string(".."),
                                   std::string("../x"), std::string("/x"), std::string("a\0b", 3)})
        CHECK_THROWS_AS(write_mark(results.folder, {.student = bad}), InputError);
}

TEST_CASE("a file that ends early is no mark, wherever it ends") {
    const Results results;
    write_mark(results.folder, class_of_two().front());
    const std::filesystem::path file = mark_file(results.folder, odd, 4);
    const std::string whole = read_text(file);
    for (std::size_t size = whole.size(); size-- > 0;) {
        std::filesystem::resize_file(file, size);
        CHECK_FALSE(read_mark(results.folder, odd, 4));
    }
    write(file, whole);
    CHECK(read_mark(results.folder, odd, 4));
}

TEST_CASE("a student may be called as a file of ours is") {
    const Results results;
    const std::vector<std::string> ours{"seed.txt",  "grades.csv", "class.html",
                                        "junit.xml", ".lock.1",    "students"};
    for (const std::string& name : ours) {
        if (name != "students") write(results.folder / name, "ours");
        write_mark(results.folder, {.student = name, .stage = 1, .key = "k"});
    }
    CHECK(read_marks(results.folder).size() == ours.size());
    write(results.folder / "anna" / "step01_ray_generation.jsonl", "a stray folder is no student");
    CHECK(read_marks(results.folder).size() == ours.size());
}

TEST_CASE("what the starter passes counts for a file whose other cases pass, and no other") {
    const CaseMark own{.name = "own", .points = 3, .passed = true};
    const CaseMark given{.name = "given", .points = 2, .passed = true, .given = true};
    CaseMark given_trace = given;
    given_trace.of_trace = true;
    CaseMark own_trace = own;
    own_trace.of_trace = true;
    Mark mark{
        .stage = 3, .verdict = Verdict::judged, .cases = {given, own, given_trace}, .most = 10};
    CHECK(mark.points() == 5);
    CHECK(mark.untested_points() == 3);
    mark.cases.push_back(own_trace);
    CHECK(mark.points() == 10);
    CHECK(mark.untested_points() == 0);
    mark.cases = {given, given_trace, own_trace};
    CHECK(mark.points() == 5);
    mark.cases = {given, given_trace};
    CHECK(mark.points() == 0);
}

TEST_CASE("a file that the grader did not write is not a mark") {
    const Results results;
    write_mark(results.folder, {.student = "anna", .stage = 2, .cases = {{.name = "one"}}});
    const std::filesystem::path file = mark_file(results.folder, "anna", 2);
    const std::string whole = read_text(file);
    for (const std::string& text :
         {std::string("\n"), std::string("[]\n"), std::string("{}\n"), std::string("null\n"),
          whole + whole, changed(whole, "\"raysteps\":1", "\"raysteps\":2"),
          changed(whole, "\"missing\"", "\"passed\""), changed(whole, "\"most\":0", "\"most\":[]"),
          changed(whole, "\"stage\":2", "\"stage\":3"),
          changed(whole, "\"points\"", "\"point\"")}) {
        write(file, text);
        CHECK_FALSE(read_mark(results.folder, "anna", 2));
    }
    CHECK_FALSE(read_mark(results.folder, "nobody", 2));
    CHECK_FALSE(read_mark(results.folder, "..", 2));
    write(results.folder / "grades.csv", "student");
    CHECK(read_marks(results.folder).empty());
    CHECK(read_marks(results.folder / "nothing").empty());
}

// The hash that identifies a submitted file.

// The examples of FIPS 180-4 and of NIST's test vectors (SHA256ShortMsg, SHA256LongMsg).
TEST_CASE("a text's SHA-256 is that of the standard's examples") {
    CHECK(sha256("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    CHECK(sha256("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    CHECK(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq") ==
          "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
    CHECK(sha256("abcdefghbcdefghicdefghijdefghijkefghijklfghijklmghijklmnhijklmnoijklmnopjklmnopqk"
                 "lmnopqrlmnopqrsmnopqrstnopqrstu") ==
          "cf5b16a778af8380036ce59e7b0492370b249b11e8f07a51afac45037afee9d1");
    CHECK(sha256("\xd3") == "28969cdfa74a12c82f3bad960b0b000aca2ac329deea5c2328ebc6f2ba9802c1");
    CHECK(sha256(std::string(1000000, 'a')) ==
          "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

// 55 bytes are padded within their block; 56, and 64, with one block more.
TEST_CASE("texts of every length around a block's have a SHA-256 each") {
    CHECK(sha256(std::string(55, 'a')) ==
          "9f4390f8d30c2dd92ec9f095b65e2b9ae9b0a925a5258e241c9f1e910f734318");
    CHECK(sha256(std::string(56, 'a')) ==
          "b35439a4ac6f0948b6d6f9e3c6af0f5f590ce20f1bde7090ef7970686ec6738a");
    CHECK(sha256(std::string(64, 'a')) ==
          "ffe054fe7ae0cb6dc65c3af9b61d5209f439851db43d0ba5997337df154668eb");
}

// The values are of the test vectors in draft-eastlake-fnv.
TEST_CASE("a text's FNV-1a hash is that of its authors' examples, in parts too") {
    CHECK(fnv1a("") == 0xcbf29ce484222325u);
    CHECK(fnv1a("a") == 0xaf63dc4c8601ec8cu);
    CHECK(fnv1a("foobar") == 0x85944171f73967e8u);
    CHECK(fnv1a("bar", fnv1a("foo")) == fnv1a("foobar"));
}

TEST_CASE("texts of one FNV-1a hash are different files") {
    // A lattice of 20 dimensions finds such a comment for any file in a second.
    const std::string right = "intersect: the right one";
    const std::string other =
        "\x65\x72\x62\x6f\x51\xc0\x2e\x2e\x2a\x6b\xf0\x5b\x25\x49\x26\x0c\x49\x23\x20\x28\x36\x25"
        "\xef\x17";
    REQUIRE(fnv1a(right) == fnv1a(other));
    CHECK(sha256(right) != sha256(other));
}

TEST_CASE("texts that are cut elsewhere are other texts") {
    CHECK(sha256_of_all("ab", "c") != sha256_of_all("a", "bc"));
    CHECK(sha256_of_all("ab", "c") == sha256_of_all("ab", "c"));
    CHECK(sha256_of_all("a") != sha256_of_all("a", ""));
}

}  // namespace rt::grade
