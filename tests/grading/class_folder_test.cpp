// The students of a class, from folders and archives as learning platforms make them.
#include "common/system/input_error.hpp"

#include "tests/grading/intake_ground.hpp"

using namespace rt;
using namespace rt::grade;
namespace fs = std::filesystem;

namespace {

std::vector<std::string> names(const ClassFolder& found) {
    std::vector<std::string> all;
    for (const Submission& each : found.submissions) all.push_back(each.student);
    return all;
}

}  // namespace

TEST_CASE("students are called as their folders are, in plain letters") {
    const Ground ground(RAYSTEPS_SEALED);
    ground.write("zoë/sphere.cpp", "");
    ground.write("a\n\"b\"<c>/sphere.cpp", "");
    ground.write("-rf/sphere.cpp", "");
    ground.write("...;x/sphere.cpp", "");
    ground.write("ann/sphere.cpp", "");
    ground.write("ann.zip", "");
    ground.write("list.txt", "is no submission");
    CHECK(ground.students() ==
          std::vector<std::string>{"_-rf", "_..._x", "a__b__c_", "ann", "ann_2", "zoë"});
}

TEST_CASE("what is printed of a name controls no terminal") {
    const Ground ground(RAYSTEPS_SEALED);
    ground.write("ann/sphere.cpp", "");
    ground.write(
        "x\xc2\x9b"
        "31m\x1b[31m\xe2\x80\xae.txt",
        "");
    CHECK(ground.find({ground.place("")}).left_over.at(0).find("x\ufffd\ufffd31m?[31m\ufffd") == 0);
}

TEST_CASE("results among the submissions are no student's") {
    const Ground ground(RAYSTEPS_SEALED);
    ground.write("ann/sphere.cpp", "");
    ground.write("seed.txt/sphere.cpp", "");
    ground.write("results/students/ann/submitted/sphere.cpp", "");
    CHECK(ground.find({ground.place("")}).submissions.size() == 3);
    CHECK(ground.find({ground.place("")}, ground.place("results/")).submissions.size() == 2);
    ground.write("results/seed.txt", "7");
    ground.write("results/grades.csv", "");
    CHECK(ground.students() == std::vector<std::string>{"ann", "seed.txt"});
}

TEST_CASE("one submission is not a class, and neither is an empty folder") {
    const Ground ground(RAYSTEPS_SEALED);
    ground.write("ann/sphere.cpp", "");
    CHECK(ground.find({ground.place("ann")}).submissions.size() == 1);
    ground.write("bob/step03_sphere/sphere.cpp", "");
    CHECK(ground.find({ground.place("ann"), ground.place("bob")}).submissions.size() == 2);
    fs::create_directory(ground.place("nobody"));
    CHECK_THROWS_AS(ground.find({ground.place("nobody")}), InputError);
    CHECK_THROWS_AS(ground.find({ground.place("missing")}), InputError);
}

TEST_CASE("Moodle's folders have a student's zip inside") {
    const Ground ground(RAYSTEPS_SEALED);
    ground.write("work/my code/sphere.cpp", "three");
    ground.zip("work", "Zoë Doe_123_assignsubmission_file_/work.zip");
    ground.write("Zoë Doe_123_assignsubmission_onlinetext_/onlinetext.html", "hello");
    ground.write("Zoë Doe_124_assignsubmission_file_/Sphere.cpp", "her namesake's");
    ground.write("Max Moe_125_assignsubmission_file_plane.cpp", "flat");
    ground.write("Rar Roe_126_assignsubmission_file_/work.rar", "Rar!");
    ground.write("Grades.csv", "");
    std::map<std::string, SubmittedFiles> all = ground.take_class();
    CHECK(all.size() == 4);
    CHECK(all["Zoë_Doe_123"].files == Files{{3, "three"}});
    CHECK(all["Zoë_Doe_124"].files == Files{{3, "her namesake's"}});
    CHECK(all["Max_Moe_125"].files == Files{{4, "flat"}});
    CHECK(all["Rar_Roe_126"].words_on_all.find("The archive work.rar cannot be opened") == 0);
    const ClassFolder found = ground.find({ground.place("")});
    REQUIRE(found.left_over.size() == 1);
    CHECK(found.left_over[0].find("Grades.csv: ") == 0);
}

TEST_CASE("a platform's files without folders are read from its archive too") {
    const Ground ground(RAYSTEPS_SEALED);
    ground.write("all/Max Moe_125_assignsubmission_file_plane.cpp", "flat");
    ground.write("all/doezoe_123_4567_sphere-1.cpp", "round");
    ground.zip("all", "submissions.zip");
    for (const Submission& each : ground.find_packed({ground.place("submissions.zip")}).submissions)
        CHECK(ground.take(each).files ==
              (each.student == "doezoe_123" ? Files{{3, "round"}} : Files{{4, "flat"}}));
}

TEST_CASE("what is said of a student's archive does not contain the student's name") {
    const Ground ground(RAYSTEPS_SEALED);
    ground.write("bob/sphere.cpp", "his");
    ground.write("eve.tar.gz", "no archive");
    const std::string words = ground.take_class()["eve"].words_on_all;
    CHECK(words.find("The archive submission.tar.gz cannot be opened") == 0);
}

TEST_CASE("a name that is too long for a file costs nobody a submission") {
    const Ground ground(RAYSTEPS_SEALED);
    const std::string too_long(200, 'x');
    ground.write("a/ann/sphere.cpp", "hers");
    ground.write("a/ben/sphere.cpp", "his");
    ground.write("a/ben/" + too_long, "");
    // tar renames what the system cannot store.
    ground.pack("class.tar", "a", {"--transform=s/xxx$/" + too_long + "/", "ann", "ben"});
    CHECK(names(ground.find_packed({ground.place("class.tar")})) ==
          std::vector<std::string>{"ann", "ben"});
}

TEST_CASE("Canvas's files have the student's name before their own") {
    const Ground ground(RAYSTEPS_SEALED);
    ground.write("doezoe_123_4567_sphere.cpp", "three");
    ground.write("doezoe_123_4568_plane-1.cpp", "four");
    ground.write("work/sphere.cpp", "late three");
    ground.zip("work", "moemax_LATE_124_4569_work.zip");
    ground.write("doezoe_125_4570_sphere.cpp", "her namesake's");
    std::map<std::string, SubmittedFiles> all = ground.take_class();
    CHECK(all.size() == 3);
    CHECK(all["doezoe_123"].files == Files{{3, "three"}, {4, "four"}});
    CHECK(all["moemax_124"].files == Files{{3, "late three"}});
    CHECK(all["doezoe_125"].files == Files{{3, "her namesake's"}});
    const ClassFolder found = ground.find({ground.place("")});
    REQUIRE(found.left_over.size() == 1);
    CHECK(found.left_over[0].find("moemax_124: Canvas marks it LATE") == 0);
}

TEST_CASE("an archive is a class if the lecturer says so, and else a submission") {
    const Ground ground(RAYSTEPS_SEALED);
    ground.write("work/inner/sphere.cpp", "a");
    ground.zip("work", "all/class/ann.zip");
    ground.write("all/class/ben/sphere.cpp", "b");
    ground.write("all/class/carl.rar", "not read");
    ground.write("all/class/dora/readme", "nothing");
    ground.write("all/class/list.txt", "nobody's");
    ground.zip("all", "submissions.zip");
    const std::string all = "class of 4, ann, ben, carl, dora, which --class would grade";
    for (const fs::path& place : {ground.place("submissions.zip"), ground.place("")}) {
        const ClassFolder found = ground.find_packed({place});
        CHECK(names(found) == std::vector<std::string>{"ann", "ben", "carl", "dora"});
        REQUIRE(found.left_over.size() == 1);
        CHECK(found.left_over[0].find("list.txt: ") == 0);
        CHECK(found.taken_as ==
              std::vector{place.string() + " is taken as a class of 4: ann, ben, carl, dora"});
        CHECK(names(ground.find({place})) == std::vector<std::string>{"submissions"});
        CHECK(ground.find({place}).taken_as.at(0).ends_with("submissions.zip looks like a " + all));
    }
    ground.write("other/sphere.cpp", "no class");
    ground.zip("other", "other.zip");
    CHECK_THROWS_AS(ground.find_packed({ground.place("other.zip")}), InputError);
}

TEST_CASE("a late archive, alone, is its student's, whatever names it contains") {
    const Ground ground(RAYSTEPS_SEALED);
    ground.write("work/Zoe Doe_123_assignsubmission_file_/sphere.cpp", "a trap");
    ground.write("work/Bob Ray_124_assignsubmission_file_/sphere.cpp", "a trap");
    ground.zip("work", "mallory.zip");
    ground.write("weeks/week1.zip", "");
    ground.write("weeks/week2.zip", "");
    ground.zip("weeks", "late/anna.zip");
    const std::string mallory = ground.place("mallory.zip").string();
    const ClassFolder found = ground.find({mallory, ground.place("late")});
    CHECK(names(found) == std::vector<std::string>{"anna", "mallory"});
    CHECK(
        found.taken_as ==
        std::vector<std::string>{
            mallory + " is taken as one submission, of mallory; mallory.zip looks like a class of "
                      "2, Bob_Ray_124, Zoe_Doe_123, which --class would grade",
            ground.place("late").string() +
                " is taken as a class of 1: anna; anna.zip looks like a class of 2, week1, week2, "
                "which --class would grade"});
    CHECK(one_submission({mallory}).taken_as ==
          std::vector{mallory + " is taken as one submission, of mallory"});
    const std::string zoe = "late/Zoe Doe_1_assignsubmission_file_a.zip";
    ground.write(zoe, "");
    CHECK(one_submission({ground.place(zoe)}).submissions[0].student == "Zoe_Doe_1");
}

TEST_CASE("the first label of a name is the platform's, and the rest is the student's own") {
    const Ground ground(RAYSTEPS_SEALED);
    const std::string moodle = "_assignsubmission_file_";
    ground.write("Mal Vex_125" + moodle + "x_123" + moodle + "sphere.cpp", "a trap");
    ground.write("Mal Vex_125" + moodle + "ann_123_4567_plane.cpp", "a trap");
    CHECK(ground.students() == std::vector<std::string>{"Mal_Vex_125"});
    const Ground canvas(RAYSTEPS_SEALED);
    canvas.write("vexmal_125_4567_x_123" + moodle + "sphere.cpp", "a trap");
    canvas.write("vexmal_125_4568_ann_123_4567_plane.cpp", "a trap");
    CHECK(canvas.students() == std::vector<std::string>{"vexmal_125"});
}

TEST_CASE("names that are one on other systems are made two") {
    const Ground ground(RAYSTEPS_SEALED);
    ground.write("Ann/sphere.cpp", "");
    ground.write("ann/sphere.cpp", "");
    ground.write("ann./sphere.cpp", "");
    ground.write("../x", "");
    CHECK(ground.students() == std::vector<std::string>{"Ann", "ann_2", "ann_3"});
    CHECK(ground.find({ground.place("")}).left_over ==
          std::vector<std::string>{"ann: is graded as ann_2, since there is Ann",
                                   "ann.: is graded as ann_3, since there is Ann"});
    CHECK(plain_name("..") == "_");
    CHECK(plain_name("../../x") == "_.._.._x");
    CHECK(plain_name("a\nb") == "a_b");
    const std::string almost_longest(79, 'a');
    CHECK(plain_name(almost_longest + "ë") == almost_longest);
}

TEST_CASE("one submission is one, whatever folders it has; a class with a stray file is neither") {
    const Ground ground(RAYSTEPS_SEALED);
    for (int i = 0; i < 10; ++i)
        ground.write("copy" + std::to_string(i) + "/sphere.cpp", std::to_string(i));
    const ClassFolder one = one_submission({ground.place("")});
    REQUIRE(one.submissions.size() == 1);
    CHECK(one.submissions[0].student == "class");
    ground.write("sphere.cpp", "stray");
    CHECK_THROWS_AS(ground.find({ground.place("")}), InputError);
    CHECK_THROWS_AS(one_submission({ground.place("nowhere")}), InputError);
}

TEST_CASE("names that look like Canvas's, of different archives or folders, are the students'") {
    const Ground archives(RAYSTEPS_SEALED);
    for (const char* name : {"tp_3_1_anna.zip", "tp_3_1_bob.zip", "tp_3_1_carl.zip"})
        archives.write(name, "");
    CHECK(archives.students() ==
          std::vector<std::string>{"tp_3_1_anna", "tp_3_1_bob", "tp_3_1_carl"});
    CHECK(names(archives.find(
              {archives.place("tp_3_1_anna.zip"), archives.place("tp_3_1_bob.zip")})) ==
          std::vector<std::string>{"tp_3_1_anna", "tp_3_1_bob"});
    const Ground folders(RAYSTEPS_SEALED);
    folders.write("lab_03_2026_anna/sphere.cpp", "hers");
    folders.write("lab_03_2026_bob/sphere.cpp", "his");
    CHECK(folders.students() == std::vector<std::string>{"lab_03_2026_anna", "lab_03_2026_bob"});
    CHECK(names(folders.find(
              {folders.place("lab_03_2026_anna/"), folders.place("lab_03_2026_bob/")})) ==
          std::vector<std::string>{"lab_03_2026_anna", "lab_03_2026_bob"});
    const Ground counted(RAYSTEPS_SEALED);
    for (const char* name : {"tp_3_1_anna.zip", "tp_3_2_bob.zip"}) counted.write(name, "");
    CHECK(counted.students() == std::vector<std::string>{"tp_3_1_anna", "tp_3_2_bob"});
}

TEST_CASE("several archives that Canvas names as one student's are said to be one submission") {
    const Ground ground(RAYSTEPS_SEALED);
    for (const char* name : {"doezoe_123_4567_work.zip", "doezoe_123_4568_more.zip"})
        ground.write(name, "");
    ground.write("moemax_124_4569_sphere.cpp", "his");
    const ClassFolder found = ground.find({ground.place("")});
    CHECK(names(found) == std::vector<std::string>{"doezoe_123", "moemax_124"});
    CHECK(found.left_over ==
          std::vector<std::string>{
              "doezoe_123: doezoe_123_4567_work.zip and doezoe_123_4568_more.zip are graded as one "
              "submission, by their numbers"});
}

TEST_CASE("a folder of a class that looks like a class itself is reported, as an archive is") {
    const Ground ground(RAYSTEPS_SEALED);
    ground.write("2024/anna/sphere.cpp", "hers");
    ground.write("2024/bob/sphere.cpp", "his");
    const std::string says = "; 2024 looks like a class of 2, anna, bob, if you name it alone";
    CHECK(ground.find({ground.place("")}).taken_as.at(0).ends_with("class of 1: 2024" + says));
    ground.write("carl/steps/step03_sphere/student/sphere.cpp", "his");
    ground.write("carl/steps/step04_plane/student/plane.cpp", "his");
    CHECK(ground.find({ground.place("")}).taken_as.at(0).ends_with("2024, carl" + says));
    CHECK(names(ground.find({ground.place("2024")})) == std::vector<std::string>{"anna", "bob"});
}
