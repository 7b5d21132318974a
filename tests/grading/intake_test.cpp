// Folders and archives of strangers, some of whom mean no good.
#include "common/course/grade/intake.hpp"
#include "common/course/files.hpp"
#include "common/input_error.hpp"

#include "tests/kit/catch.hpp"

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
    }

    [[nodiscard]] fs::path place(const std::string& name) const { return folder_ / "class" / name; }

    void write(const std::string& name, const std::string& text) const {
        fs::create_directories(place(name).parent_path());
        std::ofstream(place(name)) << text;
    }

    /// An archive of what stands in one of the folders.
    void pack(const std::string& archive, const std::string& from, const Command& words) const {
        Command tar{"tar", "-C", place(from), "-cf", place(archive)};
        tar.insert(tar.end(), words.begin(), words.end());
        REQUIRE(listen_to(tar, std::chrono::seconds(20)).status == 0);
        fs::remove_all(place(from));
    }

    [[nodiscard]] HandedIn take(const std::string& name) const {
        return take_in(workshop_, {.student = "s", .place = place(name)});
    }

    [[nodiscard]] std::vector<std::string> students() const {
        std::vector<std::string> names;
        for (const Envelope& each : find_envelopes({folder_ / "class"}))
            names.push_back(each.student);
        return names;
    }

private:
    TemporaryFolder temporary_;
    const fs::path& folder_ = temporary_.path();
    Workshop workshop_;
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
    ground.write("whole/tests/triangle.cpp", "ours");
    CHECK(ground.take("whole").files.empty());
    ground.write(step + "student_1/triangle.cpp", "a backup");
    ground.write(step + "student/triangle.cpp", "his");
    const HandedIn both = ground.take("whole");
    CHECK(both.files == Files{{5, "his"}});
    CHECK(both.words.at(5).find("2 files triangle.cpp that differ") != std::string::npos);
}

TEST_CASE("links, devices and books are not taken in") {
    const Ground ground;
    ground.write("secret/passwords", "secret");
    ground.write("links/readme", "");
    fs::create_symlink(ground.place("secret/passwords"), ground.place("links/sphere.cpp"));
    fs::create_directory_symlink(ground.place("secret"), ground.place("links/steps"));
    fs::create_symlink("/dev/zero", ground.place("links/plane.cpp"));
    REQUIRE(listen_to({"mkfifo", ground.place("links/cone.cpp")}, std::chrono::seconds(5)).status ==
            0);
    ground.write("links/square.cpp", std::string(300 * 1024, ' '));
    const HandedIn taken = ground.take("links");
    CHECK(taken.files.empty());
    for (const int stage : {3, 4, 6, 8})
        CHECK(taken.words.at(stage).find("is no file of less than") != std::string::npos);
}

TEST_CASE("archives of every usual kind are opened") {
    const Ground ground;
    const std::vector<std::pair<std::string, std::string>> kinds{
        {"zip", "--format=zip"}, {"7z", "--format=7zip"}, {"tar", "--format=gnutar"}};
    for (const auto& [ending, format] : kinds) {
        ground.write("work/code/sphere.cpp", "three");
        const fs::path archive = ground.place("a." + ending);
        const Ending made = listen_to({"cmake", "-E", "chdir", ground.place("work"), "cmake", "-E",
                                       "tar", "cf", archive, format, "--", "code"},
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
    REQUIRE(listen_to({"tar", "-C", ground.place("work"), "-rf", ground.place("link.tar"),
                       "way/sphere.cpp"},
                      std::chrono::seconds(20))
                .status == 0);
    (void)ground.take("link.tar");
    CHECK(read_text(ground.place("victim/sphere.cpp")) == "untouched");
}

TEST_CASE("what is no archive, or a bomb, is told so") {
    const Ground ground;
    ground.write("a.zip", "this is no archive");
    CHECK(ground.take("a.zip").words_on_all == "The archive cannot be opened.\n");
    // 200 MB of zeros in 200 KB: more than a file may have.
    ground.write("work/readme", "");
    std::ofstream(ground.place("work/sphere.cpp"));
    fs::resize_file(ground.place("work/sphere.cpp"), 200 << 20);
    ground.pack("bomb.tar.gz", "work", {"--gzip", "sphere.cpp"});
    const HandedIn bomb = ground.take("bomb.tar.gz");
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
    ground.write("results/ann/submitted/sphere.cpp", "");
    CHECK(find_envelopes({ground.place("")}).size() == 3);
    CHECK(find_envelopes({ground.place("")}, ground.place("results/")).size() == 2);
    ground.write("results/seed.txt", "7");
    ground.write("results/grades.csv", "");
    CHECK(ground.students() == std::vector<std::string>{"ann", "seed.txt"});
}

TEST_CASE("one submission is no class, and nothing is none") {
    const Ground ground;
    ground.write("ann/sphere.cpp", "");
    CHECK(find_envelopes({ground.place("ann")}).size() == 1);
    ground.write("bob/step03_sphere/sphere.cpp", "");
    CHECK(find_envelopes({ground.place("ann"), ground.place("bob")}).size() == 2);
    fs::create_directory(ground.place("nobody"));
    CHECK_THROWS_AS(find_envelopes({ground.place("nobody")}), InputError);
    CHECK_THROWS_AS(find_envelopes({ground.place("missing")}), InputError);
}
