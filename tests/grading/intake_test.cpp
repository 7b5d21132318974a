// A student's files, from untrusted folders and archives, some of them hostile.
#include "common/system/input_error.hpp"
#include "common/system/parallel_for.hpp"

#include "tests/grading/intake_ground.hpp"

#include <unistd.h>

#include <atomic>
#include <csignal>

using namespace rt;
using namespace rt::grade;
namespace fs = std::filesystem;

TEST_CASE("results inside a submission give nobody another's files") {
    const Ground ground(RAYSTEPS_SEALED);
    ground.write("ann/sphere.cpp", "hers");
    ground.write("ann/results/students/ben/submitted/plane.cpp", "his");
    CHECK(ground.take("ann").files.size() == 2);
    ground.write("ann/results/seed.txt", "7");
    CHECK(ground.take("ann").files == Files{{3, "hers"}});
}

TEST_CASE("a full disk is no fault of a submission") {
    const Ground ground(RAYSTEPS_SEALED);
    CHECK_NOTHROW(check_space(ground.place("")));
    CHECK_THROWS_AS(check_space(ground.place(""), fs::space(ground.place("")).capacity + 1),
                    InputError);
    if (fs::space("/proc").capacity == 0) CHECK_NOTHROW(check_space("/proc"));
}

TEST_CASE(
    "an archive without a file, and one that is no file, are distinguished from a damaged one") {
    const Ground ground(RAYSTEPS_SEALED);
    ground.write("none/x", "");
    fs::remove(ground.place("none/x"));
    ground.pack("none.tar", "none", {"--files-from=/dev/null"});
    CHECK(ground.take("none.tar").words_on_all == "The archive none.tar is empty.\n");
    ground.write("ann/x", "");
    fs::create_symlink("x", ground.place("ann/work.zip"));
    CHECK(ground.take("ann").words_on_all ==
          "The archive work.zip was not opened: a link, or not a regular file.\n");
}

TEST_CASE("a folder that cannot be read hides nothing but its own files") {
    if (geteuid() == 0) return;  // who reads every folder
    const Ground ground(RAYSTEPS_SEALED);
    for (const char* name : {"ann/a/sphere.cpp", "ann/b/x", "ann/c/plane.cpp"})
        ground.write(name, "hers");
    fs::permissions(ground.place("ann/b"), fs::perms::none);
    const SubmittedFiles found = ground.take("ann");
    fs::permissions(ground.place("ann/b"), fs::perms::owner_all);
    CHECK(found.files == Files{{3, "hers"}, {4, "hers"}});
    CHECK(found.words_on_all == "The folder b cannot be read.\n");
}

TEST_CASE("a file is found by its name, wherever it is") {
    const Ground ground(RAYSTEPS_SEALED);
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

TEST_CASE("a file that an editor or a copy has renamed is named, and so is nothing at all") {
    const Ground ground(RAYSTEPS_SEALED);
    for (const char* name : {"sphere.cpp~", "sphere.cpp.bak", "sphere.cpp ", "sphere.cpp.",
                             "Sphere.cc.orig", "step03_sphere.cpp.old", "#sphere.cpp#"}) {
        INFO(name);
        ground.write(std::string("step03_sphere/") + name, "three");
        const SubmittedFiles taken = ground.take("step03_sphere");
        CHECK(taken.files.empty());
        CHECK(taken.words.at(3) == std::string("There is no sphere.cpp. Found, but not used: ") +
                                       name + " (its name is not a stage's).\n");
        fs::remove_all(ground.place("step03_sphere"));
    }
    fs::create_directory(ground.place("ann"));
    CHECK(ground.take("ann").words_on_all == "The submission contains no file.\n");
    ground.write("ann/report.pdf", "");
    CHECK(ground.take("ann").words_on_all == "No file is a C++ source. Found: report.pdf.\n");
}

TEST_CASE("a main.cpp is the trace of the stage that its folder or its name gives") {
    const Ground ground(RAYSTEPS_SEALED);
    const GradedFile trace(3, true);
    const auto only = [&](const std::string& name) {
        INFO(name);
        ground.write("ann/" + name, "trace");
        CHECK(ground.take("ann").files == Files{{trace, "trace"}});
        fs::remove_all(ground.place("ann"));
    };
    only("raysteps/steps/step03_sphere/student/main.cpp");
    only("step03_sphere/main.cpp");
    only("step03/main.cpp");
    only("sphere/main.cc");
    only("03_sphere/main.cpp");
    only("stage 3/src/main.cpp");
    only("Step03-Sphere/main.cpp");
    only("sphere_main.cpp");
    only("step03_sphere_main.cpp");
    only("step03_main (1).cpp");

    // Stage 1's has the loop over the pixels; stage 2 has none.
    ground.write("cid/step01_ray_generation/main.cpp", "loop");
    ground.write("cid/camera_basis_main.cpp", "of no stage");
    CHECK(ground.take("cid").files == Files{{{1, true}, "loop"}});
    fs::remove(ground.place("cid/step01_ray_generation/main.cpp"));
    ground.write("cid/ray_generation_main.cpp", "loop");
    CHECK(ground.take("cid").files == Files{{{1, true}, "loop"}});

    ground.write("ben/week 1/sphere.cpp", "three");
    ground.write("ben/week 1/main.cpp", "trace");
    CHECK(ground.take("ben").files == Files{{3, "three"}, {trace, "trace"}});
    ground.write("ben/week 1/plane.cpp", "four");
    const SubmittedFiles several = ground.take("ben");
    CHECK(several.files == Files{{3, "three"}, {4, "four"}});
    CHECK(several.words.at({4, true}).find("would be plane_main.cpp") != std::string::npos);
}

TEST_CASE("a main.cpp that belongs to no stage is named") {
    const Ground ground(RAYSTEPS_SEALED);
    ground.write("ann/sphere.cpp", "three");
    ground.write("ann/ball/main.cpp", "whose?");
    const SubmittedFiles taken = ground.take("ann");
    CHECK(taken.files == Files{{3, "three"}});
    CHECK(taken.words_on_all.find("ball/main.cpp is not used: ") == 0);
}

TEST_CASE("a main.cpp of the project, and one of another program, are no trace") {
    const Ground ground(RAYSTEPS_SEALED);
    for (const char* name :
         {"steps/step03_sphere/main.cpp", "steps/step03_sphere/starter/main.cpp",
          "steps/step02_camera_basis/student/main.cpp", "common/program/main.cpp", "main.cpp"})
        ground.write(std::string("whole/") + name, "ours");
    const SubmittedFiles taken = ground.take("whole");
    CHECK(taken.files.empty());
    CHECK(taken.words.at({3, true}).find("steps/step03_sphere/main.cpp (a file of the project") !=
          std::string::npos);
    ground.write("whole/steps/step03_sphere/student/main.cpp", "his");
    CHECK(ground.take("whole").files == Files{{{3, true}, "his"}});
}

TEST_CASE("links, devices and books are not collected") {
    const Ground ground(RAYSTEPS_SEALED);
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
    const Ground ground(RAYSTEPS_SEALED);
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
    const Ground ground(RAYSTEPS_SEALED);
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
    const Ground ground(RAYSTEPS_SEALED);
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

TEST_CASE("names given by people and browsers are accepted, and reported") {
    const Ground ground(RAYSTEPS_SEALED);
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
    const Ground ground(RAYSTEPS_SEALED);
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
    const Ground ground(RAYSTEPS_SEALED);
    for (int i = 0; i < 3000; ++i)
        ground.write("work/a/" + std::string(40, 'x') + std::to_string(i), "");
    ground.write("work/b/sphere.cpp", "three");
    ground.pack("a.tar.gz", "work", {"--gzip", "a", "b"});
    CHECK(ground.take("a.tar.gz").files == Files{{3, "three"}});
}

TEST_CASE("names in archives are names, and no patterns") {
    const Ground ground(RAYSTEPS_SEALED);
    ground.write("work/*/sphere.cpp", "star");
    for (int i = 0; i < 400; ++i)
        ground.write("work/x" + std::to_string(i) + "\n/sphere.cpp/notes.txt", "x");
    ground.write("work/[a-z]^$?.cpp", "x");
    ground.pack("a.tar", "work", {"."});
    const SubmittedFiles taken = ground.take("a.tar");
    CHECK(taken.files == Files{{3, "star"}});
    CHECK(taken.words.empty());
}

TEST_CASE("a name in no encoding is reported, and the other files are read") {
    const Ground ground(RAYSTEPS_SEALED);
    ground.write("work/aXb/sphere.cpp", "three");
    ground.write("work/plane.cpp", "four");
    ground.zip("work", "a.zip");
    std::string bytes = read_text(ground.place("a.zip"));
    for (std::size_t at = 0; (at = bytes.find("aXb/", at)) != std::string::npos; ++at) {
        bytes[at + 1] = '\xff';
        for (const auto& [start, flags] : {std::pair("PK\3\4", 7), std::pair("PK\1\2", 9)})
            if (at >= 46 && bytes.rfind(start, at) + (flags == 7 ? 30 : 46) == at)
                bytes[bytes.rfind(start, at) + std::size_t(flags)] |= 8;  // marks UTF-8
    }
    write_text(ground.place("a.zip"), bytes);
    const SubmittedFiles taken = ground.take("a.zip");
    CHECK(taken.files == Files{{4, "four"}});
    CHECK(taken.words_on_all == "The archive a.zip contains a file whose name cannot be read.\n");
}

TEST_CASE("a link among an archive's names spoils nothing, and is never followed") {
    const Ground ground(RAYSTEPS_SEALED);
    ground.write("work/code/sphere.cpp", "three");
    fs::create_symlink("/etc/passwd", ground.place("work/sphere.cpp"));
    fs::create_symlink("/etc/passwd", ground.place("work/plane.cpp"));
    ground.pack("a.tar", "work", {"."});
    const SubmittedFiles taken = ground.take("a.tar");
    CHECK(taken.files == Files{{3, "three"}});
    CHECK(taken.words.at(4).find("plane.cpp (a link)") != std::string::npos);
}

TEST_CASE("the total size of an archive's files is limited") {
    const Ground ground(RAYSTEPS_SEALED);
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

TEST_CASE("a part of many problems is reported, and the end of a very long name") {
    const Ground ground(RAYSTEPS_SEALED);
    std::string folder = "work/";
    for (int i = 0; i < 20; ++i) folder += std::string(100, 'x') + "/";
    ground.write(folder + "ball.cpp", "");
    for (int i = 0; i < 100; ++i) ground.write("work/" + std::to_string(i) + ".zip", "");
    ground.pack("a.tar", "work", {"."});
    const std::string words = ground.take("a.tar").words_on_all;
    CHECK(words.find("xxx/ball.cpp.\n") != std::string::npos);
    CHECK(words.size() < 2500);
}

TEST_CASE("a Mac's archive has twice the names, and one student's files") {
    const Ground ground(RAYSTEPS_SEALED);
    ground.write("work/work/sphere.cpp", "three");
    ground.write("work/work/.DS_Store", "x");
    ground.write("work/work/._sphere.cpp", "x");
    ground.write("work/__MACOSX/work/._sphere.cpp", "x");
    ground.write("work/__MACOSX/work/sphere.cpp", "not his");
    ground.zip("work", "ann.zip");
    const SubmittedFiles taken = ground.take("ann.zip");
    CHECK(taken.files == Files{{3, "three"}});
    CHECK(taken.words.empty());
    CHECK(ground.students() == std::vector<std::string>{"ann"});
}

TEST_CASE("many archives are opened at a time") {
    const Ground ground(RAYSTEPS_SEALED);
    ground.write("work/sphere.cpp", "three");
    ground.pack("a.tar.gz", "work", {"--gzip", "."});
    std::atomic<int> right = 0;
    parallel_for(4, 60, nullptr, [&](std::size_t) {
        if (ground.take("a.tar.gz").files == Files{{3, "three"}}) ++right;
    });
    CHECK(right == 60);
}

TEST_CASE("archives in archives end, and one that goes on for ever is the last") {
    const Ground ground(RAYSTEPS_SEALED);
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

TEST_CASE("an archive that is larger than the disk is read without a copy") {
    const Ground ground(RAYSTEPS_SEALED);
    ground.write("work/sphere.cpp", "sphere");
    ground.pack("work.tar", "work", {"sphere.cpp"});
    std::error_code limited;
    fs::resize_file(ground.place("work.tar"), fs::space(ground.place("")).available + (1ULL << 33),
                    limited);
    if (limited) return;  // the disk has no files with holes, or a limit of their sizes
    CHECK(ground.take("work.tar").files == Files{{3, "sphere"}});
}

TEST_CASE("a tool that the clock ends is the machine's fault, by its processor time its own") {
    const Ground ground(RAYSTEPS_SEALED);
    const fs::path folder = ground.workshop().folder / "scratch";
    fs::create_directory(folder);
    const auto run = [&](const std::string& script, const ToolLimits& limits) {
        return run_sealed(ground.workshop(), folder, {}, {"/bin/sh", "-c", script}, limits).status;
    };
    CHECK_THROWS_AS(run("sleep 1000", {.wall_seconds = 1}), ProgramError);
    const int too_long = run("while :; do :; done", {.processor_seconds = 1, .wall_seconds = 60});
    CHECK((too_long == 128 + SIGXCPU || too_long == 128 + SIGKILL));
    // The system kills a program when the memory is full; here it does at a limit. A submission can
    // choose what its compiler prints, and not how it ends.
    CHECK_THROWS_AS(run("(ulimit -t 1; while :; do :; done) || exit $?", {}), ProgramError);
    const std::string says = "echo 'g++: fatal error: Killed signal terminated program cc1plus'; ";
    CHECK(run(says + "echo 'compilation terminated.'; exit 1", {}) == 1);
    // Two of its processes use what one may, and the clock ends a third.
    CHECK(run("for i in 1 2; do (ulimit -t 1; while :; do :; done); done; sleep 1000",
              {.processor_seconds = 2, .wall_seconds = 10}) == 128 + SIGXCPU);
}
