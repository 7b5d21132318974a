// Untrusted folders and archives, some of them hostile.
#include "common/course/grade/judging/class_folder.hpp"
#include "common/system/files.hpp"
#include "common/system/input_error.hpp"
#include "common/system/parallel_for.hpp"

#include "tests/kit/catch.hpp"

#include <atomic>
#include <fstream>

using namespace rt;
using namespace rt::grade;
namespace fs = std::filesystem;

namespace {

/// A class to be, and a workshop, in a folder of their own.
class Ground {
public:
    Ground() {
        fs::permissions(folder_, fs::perms(0755));
        for (const char* each : {"class", "workshop"}) fs::create_directory(folder_ / each);
        fs::permissions(folder_ / "workshop", fs::perms(0755));
        workshop_ = {.folder = folder_ / "workshop", .sealed = RAYSTEPS_SEALED};
        fs::copy_file(workshop_.sealed.parent_path() / "unpack", folder_ / "workshop/unpack");
    }

    [[nodiscard]] fs::path place(const std::string& name) const { return folder_ / "class" / name; }

    void write(const std::string& name, const std::string& text) const {
        fs::create_directories(place(name).parent_path());
        std::ofstream(place(name)) << text;
    }

    /// An archive of the contents of one of the folders.
    void pack(const std::string& archive, const std::string& from, const Command& words) const {
        Command tar{"tar", "-C", place(from), "-cf", place(archive)};
        tar.insert(tar.end(), words.begin(), words.end());
        REQUIRE(run_captured(tar, std::chrono::seconds(20)).status == 0);
        fs::remove_all(place(from));
    }

    [[nodiscard]] SubmittedFiles take(const std::string& name) const {
        return take_in(workshop_, {.student = "s", .pieces = {{place(name), name}}});
    }

    [[nodiscard]] std::vector<std::string> students() const {
        std::vector<std::string> names;
        for (const Submission& each : find({folder_ / "class"}).submissions)
            names.push_back(each.student);
        return names;
    }

    [[nodiscard]] ClassFolder find(const std::vector<fs::path>& places,
                                   const fs::path& results = {}) const {
        return find_class(workshop_, places, results);
    }

    /// By student: the submissions of a class that consists of these only.
    [[nodiscard]] std::map<std::string, SubmittedFiles> take_class() const {
        std::map<std::string, SubmittedFiles> all;
        for (const Submission& each : find({folder_ / "class"}).submissions)
            all[each.student] = take_in(workshop_, each);
        return all;
    }

private:
    TemporaryFolder temporary_;
    const fs::path& folder_ = temporary_.path();
    BuildDirectory workshop_;
};

using Files = std::map<int, std::string>;

}  // namespace

TEST_CASE("a file is found by its name, wherever it is") {
    const Ground ground;
    ground.write("flat/sphere.cpp", "three");
    ground.write("flat/notes.cpp", "no stage's");
    CHECK(ground.take("flat").files == Files{{3, "three"}});
    ground.write("deep/my work/week 2/plane.cpp", "four");
    CHECK(ground.take("deep").files == Files{{4, "four"}});
    const std::string step = "whole/steps/step05_triangle/";
    ground.write(step + "reference/triangle.cpp", "ours");
    ground.write(step + "starter/triangle.cpp", "ours");
    const SubmittedFiles ours = ground.take("whole");
    CHECK(ours.files.empty());
    CHECK(ours.words.at(5).find("starter/triangle.cpp (a file of the project, not yours)") !=
          std::string::npos);
    ground.write("whole/tests/triangle.cpp", "misplaced");
    CHECK(ground.take("whole").files == Files{{5, "misplaced"}});
    ground.write(step + "student_1/triangle.cpp", "a backup");
    ground.write(step + "student/triangle.cpp", "his");
    const SubmittedFiles both = ground.take("whole");
    CHECK(both.files == Files{{5, "his"}});
    CHECK(both.words.at(5).find("3 files for triangle.cpp that differ; "
                                "steps/step05_triangle/student/triangle.cpp was used") !=
          std::string::npos);
}

TEST_CASE("links, devices and books are not collected") {
    const Ground ground;
    ground.write("secret/passwords", "secret");
    ground.write("links/readme", "");
    fs::create_symlink(ground.place("secret/passwords"), ground.place("links/sphere.cpp"));
    fs::create_directory_symlink(ground.place("secret"), ground.place("links/steps"));
    fs::create_symlink("/dev/zero", ground.place("links/plane.cpp"));
    REQUIRE(
        run_captured({"mkfifo", ground.place("links/cone.cpp")}, std::chrono::seconds(5)).status ==
        0);
    ground.write("links/square.cpp", std::string(300 * 1024, ' '));
    const SubmittedFiles taken = ground.take("links");
    CHECK(taken.files.empty());
    for (const int stage : {3, 4, 8})
        CHECK(taken.words.at(stage).find("(a link, or not a regular file)") != std::string::npos);
    CHECK(taken.words.at(6).find("square.cpp (more than 256 KiB") != std::string::npos);
}

TEST_CASE("archives of every usual kind are opened") {
    const Ground ground;
    const std::vector<std::pair<std::string, std::string>> kinds{
        {"zip", "--format=zip"}, {"7z", "--format=7zip"}, {"tar", "--format=gnutar"}};
    for (const auto& [ending, format] : kinds) {
        ground.write("work/code/sphere.cpp", "three");
        const fs::path archive = ground.place("a." + ending);
        const ProcessResult made =
            run_captured({"cmake", "-E", "chdir", ground.place("work"), "cmake", "-E", "tar", "cf",
                          archive, format, "--", "code"},
                         std::chrono::seconds(20));
        REQUIRE(made.status == 0);
        INFO(ending);
        CHECK(ground.take("a." + ending).files == Files{{3, "three"}});
    }
    ground.write("work/sphere.cpp", "three");
    ground.pack("b.tar.gz", "work", {"--gzip", "."});
    CHECK(ground.take("b.tar.gz").files == Files{{3, "three"}});
}

TEST_CASE("an archive leads nowhere else") {
    const Ground ground;
    ground.write("victim/sphere.cpp", "untouched");
    ground.write("work/x/sphere.cpp", "wicked");
    ground.pack("up.tar", "work", {"-P", "--transform", "s|x|../../class/victim|", "x/sphere.cpp"});
    CHECK(ground.take("up.tar").files.empty());
    ground.write("work/sphere.cpp", "wicked");
    const std::string victim = ground.place("victim");
    ground.pack("root.tar", "work", {"-P", "--transform", "s|^|" + victim + "/|", "sphere.cpp"});
    CHECK(ground.take("root.tar").files.empty());
    // A link to a folder, and then a file through it.
    ground.write("work/readme", "");
    fs::create_directory_symlink(victim, ground.place("work/way"));
    ground.pack("link.tar", "work", {"way"});
    ground.write("work/way/sphere.cpp", "wicked");
    REQUIRE(run_captured({"tar", "-C", ground.place("work"), "-rf", ground.place("link.tar"),
                          "way/sphere.cpp"},
                         std::chrono::seconds(20))
                .status == 0);
    (void)ground.take("link.tar");
    CHECK(read_text(ground.place("victim/sphere.cpp")) == "untouched");
}

TEST_CASE("a file that is not an archive, and a bomb, are reported") {
    const Ground ground;
    ground.write("a.zip", "this is no archive");
    CHECK(ground.take("a.zip").words_on_all.find("The archive a.zip cannot be opened") == 0);
    // 200 MB of zeros in 200 KB: more than a file may have.
    ground.write("work/readme", "");
    std::ofstream(ground.place("work/sphere.cpp"));
    fs::resize_file(ground.place("work/sphere.cpp"), 200 << 20);
    ground.pack("bomb.tar.gz", "work", {"--gzip", "sphere.cpp"});
    const SubmittedFiles bomb = ground.take("bomb.tar.gz");
    CHECK(bomb.files.empty());
    CHECK_FALSE((bomb.words_on_all.empty() && bomb.words.empty()));
}

TEST_CASE("students are called as their folders are, in plain letters") {
    const Ground ground;
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

TEST_CASE("results among the submissions are no student's") {
    const Ground ground;
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
    const Ground ground;
    ground.write("ann/sphere.cpp", "");
    CHECK(ground.find({ground.place("ann")}).submissions.size() == 1);
    ground.write("bob/step03_sphere/sphere.cpp", "");
    CHECK(ground.find({ground.place("ann"), ground.place("bob")}).submissions.size() == 2);
    fs::create_directory(ground.place("nobody"));
    CHECK_THROWS_AS(ground.find({ground.place("nobody")}), InputError);
    CHECK_THROWS_AS(ground.find({ground.place("missing")}), InputError);
}

namespace {

/// A zip of a folder's contents, unchanged.
void zip(const Ground& ground, const std::string& from, const std::string& archive) {
    const fs::path to = ground.place(archive);
    fs::create_directories(to.parent_path());
    Command zip{"cmake", "-E", "chdir", ground.place(from), "cmake", "-E",
                "tar",   "cf", to,      "--format=zip",     "--"};
    for (const auto& each : fs::directory_iterator(ground.place(from)))
        zip.push_back(each.path().filename());
    REQUIRE(run_captured(zip, std::chrono::seconds(60)).status == 0);
    fs::remove_all(ground.place(from));
}

}  // namespace

TEST_CASE("names given by people and browsers are accepted, and reported") {
    const Ground ground;
    const std::vector<std::pair<std::string, int>> near{
        {"Sphere.cpp", 3},        {"sphere.cc", 3},         {"sphere (1).cpp", 3},
        {"sphere-1.cpp", 3},      {"SPHERE.CPP", 3},        {"step03_sphere.cpp", 3},
        {"sphere - Copy.cpp", 3}, {"sphere copy 2.cxx", 3}, {"SoftShadows.cpp", 11},
        {"soft-shadows.cpp", 11}, {"camera basis.C", 2},    {"03_sphere.cpp", 3}};
    for (const auto& [name, stage] : near) {
        INFO(name);
        ground.write("ann/" + name, "his");
        const SubmittedFiles taken = ground.take("ann");
        CHECK(taken.files == Files{{stage, "his"}});
        CHECK(taken.words.at(stage).find(name + " was used as ") == 0);
        fs::remove_all(ground.place("ann"));
    }
    for (const char* folder : {"tests", "build", "src"}) {
        ground.write(std::string("ann/") + folder + "/sphere.cpp", "his");
        CHECK(ground.take("ann").files == Files{{3, "his"}});
        fs::remove_all(ground.place("ann"));
    }
    ground.write("ann/Sphere.cpp", "near");
    ground.write("ann/deep/down/sphere.cpp", "exact");
    CHECK(ground.take("ann").files == Files{{3, "exact"}});
}

TEST_CASE("near names that are not used are reported; so are all sources if none is used") {
    const Ground ground;
    for (const char* name : {"shpere.cpp", "sphere.txt", "sphere.cpp.txt", "spheres.cpp"}) {
        ground.write(std::string("ann/") + name, "");
        const SubmittedFiles taken = ground.take("ann");
        CHECK(taken.files.empty());
        CHECK(taken.words.at(3).find(name) != std::string::npos);
        fs::remove_all(ground.place("ann"));
    }
    ground.write("ann/ball.cpp", "");
    CHECK(ground.take("ann").words_on_all == "No file has a stage's name. Found: ball.cpp.\n");
    ground.write("ann/plane.cpp", "");
    CHECK(ground.take("ann").words_on_all == "");
}

TEST_CASE("an archive whose list of names is long is read to its end") {
    const Ground ground;
    for (int i = 0; i < 3000; ++i)
        ground.write("work/a/" + std::string(40, 'x') + std::to_string(i), "");
    ground.write("work/b/sphere.cpp", "three");
    ground.pack("a.tar.gz", "work", {"--gzip", "a", "b"});
    CHECK(ground.take("a.tar.gz").files == Files{{3, "three"}});
}

TEST_CASE("names in archives are names, and no patterns") {
    const Ground ground;
    ground.write("work/*/sphere.cpp", "star");
    for (int i = 0; i < 400; ++i)
        ground.write("work/x" + std::to_string(i) + "\n/sphere.cpp/notes.txt", "x");
    ground.write("work/[a-z]^$?.cpp", "x");
    ground.pack("a.tar", "work", {"."});
    const SubmittedFiles taken = ground.take("a.tar");
    CHECK(taken.files == Files{{3, "star"}});
    CHECK(taken.words.empty());
}

TEST_CASE("a link among an archive's names spoils nothing, and is never followed") {
    const Ground ground;
    ground.write("work/code/sphere.cpp", "three");
    fs::create_symlink("/etc/passwd", ground.place("work/sphere.cpp"));
    fs::create_symlink("/etc/passwd", ground.place("work/plane.cpp"));
    ground.pack("a.tar", "work", {"."});
    const SubmittedFiles taken = ground.take("a.tar");
    CHECK(taken.files == Files{{3, "three"}});
    CHECK(taken.words.at(4).find("plane.cpp (a link)") != std::string::npos);
}

TEST_CASE("the total size of an archive's files is limited") {
    const Ground ground;
    const std::string large(250 * 1024, ' ');
    ground.write("work/0/plane.cpp", "four");
    for (int i = 0; i < 150; ++i)
        ground.write("work/x/" + std::to_string(i) + "/sphere.cpp", large);
    ground.write("work/z/cone.cpp", large);
    ground.pack("bomb.tar.gz", "work", {"--gzip", "0", "x", "z"});
    const SubmittedFiles taken = ground.take("bomb.tar.gz");
    CHECK(taken.files.at(4) == "four");
    CHECK(taken.files.count(8) == 0);
    CHECK(taken.words.at(8).find("z/cone.cpp (too large)") != std::string::npos);
    // Ignored files are reported if the stage has no other file.
    ground.write("work/sphere.cpp", "");
    fs::resize_file(ground.place("work/sphere.cpp"), 40 << 20);
    ground.pack("large.tar.gz", "work", {"--gzip", "sphere.cpp"});
    CHECK(ground.take("large.tar.gz").words.at(3).find("sphere.cpp (too large)") !=
          std::string::npos);
}

TEST_CASE("a Mac's archive has twice the names, and one student's files") {
    const Ground ground;
    ground.write("work/work/sphere.cpp", "three");
    ground.write("work/work/.DS_Store", "x");
    ground.write("work/work/._sphere.cpp", "x");
    ground.write("work/__MACOSX/work/._sphere.cpp", "x");
    ground.write("work/__MACOSX/work/sphere.cpp", "not his");
    zip(ground, "work", "ann.zip");
    const SubmittedFiles taken = ground.take("ann.zip");
    CHECK(taken.files == Files{{3, "three"}});
    CHECK(taken.words.empty());
    CHECK(ground.students() == std::vector<std::string>{"ann"});
}

TEST_CASE("Moodle's folders have a student's zip inside") {
    const Ground ground;
    ground.write("work/my code/sphere.cpp", "three");
    zip(ground, "work", "Zoë Doe_123_assignsubmission_file_/work.zip");
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

TEST_CASE("Canvas's files have the student's name before their own") {
    const Ground ground;
    ground.write("doezoe_123_4567_sphere.cpp", "three");
    ground.write("doezoe_123_4568_plane-1.cpp", "four");
    ground.write("work/sphere.cpp", "late three");
    zip(ground, "work", "moemax_LATE_124_4569_work.zip");
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

TEST_CASE("a class in one archive is a class, and a student's own archive is not") {
    const Ground ground;
    ground.write("work/inner/sphere.cpp", "a");
    zip(ground, "work", "all/class/ann.zip");
    ground.write("all/class/ben/sphere.cpp", "b");
    ground.write("all/class/carl.rar", "not read");
    ground.write("all/class/dora/readme", "nothing");
    ground.write("all/class/list.txt", "nobody's");
    zip(ground, "all", "submissions.zip");
    for (const fs::path& place : {ground.place("submissions.zip"), ground.place("")}) {
        const ClassFolder found = ground.find({place});
        std::vector<std::string> names;
        for (const Submission& each : found.submissions) names.push_back(each.student);
        CHECK(names == std::vector<std::string>{"ann", "ben", "carl", "dora"});
        REQUIRE(found.left_over.size() == 1);
        CHECK(found.left_over[0].find("list.txt: ") == 0);
    }
    // Beside others it belongs to one student, whatever names it contains.
    ground.write("work/doezoe_123_4567_sphere.cpp", "a trap");
    ground.write("work/doezoe_124_4567_sphere.cpp", "a trap");
    zip(ground, "work", "eve.zip");
    CHECK(ground.students() == std::vector<std::string>{"eve", "submissions"});
}

TEST_CASE("names that are one on other systems are made two") {
    const Ground ground;
    ground.write("Ann/sphere.cpp", "");
    ground.write("ann/sphere.cpp", "");
    ground.write("ann./sphere.cpp", "");
    ground.write("../x", "");
    CHECK(ground.students() == std::vector<std::string>{"Ann", "ann_2", "ann_3"});
    CHECK(ground.find({ground.place("")}).left_over ==
          std::vector<std::string>{"ann: is graded as ann_2, since there is another ann",
                                   "ann.: is graded as ann_3, since there is another ann"});
    CHECK(plain_name("..") == "_");
    CHECK(plain_name("../../x") == "_.._.._x");
    CHECK(plain_name("a\nb") == "a_b");
    CHECK(plain_name(std::string(79, 'a') + "ë") == std::string(79, 'a'));
}

TEST_CASE("one submission is one, whatever folders it has; a class with a stray file is neither") {
    const Ground ground;
    for (int i = 0; i < 10; ++i)
        ground.write("copy" + std::to_string(i) + "/sphere.cpp", std::to_string(i));
    const ClassFolder one = one_submission({ground.place("")});
    REQUIRE(one.submissions.size() == 1);
    CHECK(one.submissions[0].student == "class");
    ground.write("sphere.cpp", "stray");
    CHECK_THROWS_AS(ground.find({ground.place("")}), InputError);
    CHECK_THROWS_AS(one_submission({ground.place("nowhere")}), InputError);
}

TEST_CASE("many archives are opened at a time") {
    const Ground ground;
    ground.write("work/sphere.cpp", "three");
    ground.pack("a.tar.gz", "work", {"--gzip", "."});
    std::atomic<int> right = 0;
    parallel_for(4, 60, nullptr, [&](std::size_t) {
        if (ground.take("a.tar.gz").files == Files{{3, "three"}}) ++right;
    });
    CHECK(right == 60);
}

TEST_CASE("archives in archives end, and one that goes on for ever is the last") {
    const Ground ground;
    ground.write("work/0/sphere.cpp", "three");
    for (int i = 0; i < 5; ++i) {
        ground.write("inner/x", "");
        if (i > 0) fs::rename(ground.place("last.tar"), ground.place("inner/a.tar"));
        if (i == 0) ground.write("inner/plane.cpp", "four");
        ground.pack("last.tar", "inner", {"."});
    }
    ground.write("work/2/x", "");
    fs::rename(ground.place("last.tar"), ground.place("work/2/a.tar"));
    ground.pack("a.tar", "work", {"."});
    const SubmittedFiles taken = ground.take("a.tar");
    CHECK(taken.files == Files{{3, "three"}});
    // More than 1 GB of zeros, and then a file: parts that gzip takes as one.
    ground.write("work/zeros", "");
    fs::resize_file(ground.place("work/zeros"), std::uintmax_t(20 * 64) << 20);
    ground.write("work/sphere.cpp", "after");
    const ProcessResult made = run_captured(
        {"sh", "-c",
         "cd \"$1\" && tar -cf - zeros | head -c 512 | gzip > ../bomb.tar.gz &&"
         "head -c 64M zeros | gzip > part && for i in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 "
         "19 20; do cat part >> ../bomb.tar.gz; done && tar -cf - sphere.cpp | gzip >> "
         "../bomb.tar.gz",
         "sh", ground.place("work")},
        std::chrono::seconds(60));
    REQUIRE(made.status == 0);
    const SubmittedFiles bomb = ground.take("bomb.tar.gz");
    CHECK(bomb.files.empty());
    CHECK(bomb.words_on_all.find("bomb.tar.gz is damaged, or too large") != std::string::npos);
}
