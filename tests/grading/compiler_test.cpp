// How the grader runs the compiler on a submission: what it may read, how often it runs, and how
// its end is told.
#include "common/course/grade/judging/workshop.hpp"
#include "common/stages/stages.hpp"
#include "common/system/files.hpp"

#include "tests/kit/catch.hpp"

#include <unistd.h>

#include <fstream>
#include <string>
#include <utility>

using namespace rt;
using namespace std::string_literals;
namespace fs = std::filesystem;

namespace {

std::string reference(const std::string& stage) {
    return read_text(RAYSTEPS_ROOT "/steps/" + stage + "/reference/" +
                     stage.substr(stage.find('_') + 1) + ".cpp");
}

/// A build directory of the grader whose link kits a test may change, and a folder beside it, which
/// all users may read.
class ChangedKits {
public:
    ChangedKits() : workshop_(grade::open_workshop(RAYSTEPS_ROOT, RAYSTEPS_BUILD, folder_.path())) {
        for (const TemporaryFolder* each : {&folder_, &beside_})
            fs::permissions(each->path(), fs::perms(0755));
    }

    [[nodiscard]] const fs::path& beside() const { return beside_.path(); }
    [[nodiscard]] bool has(const std::string& stage, const std::string& word) const {
        return read_text(kit(stage)).find("\n" + word + " ") != std::string::npos;
    }

    /// Adds a line of options to a stage's link kit.
    void add(const std::string& stage, const std::string& option) const {
        std::ofstream(kit(stage), std::ios::app) << "compile " << option << '\n';
    }

    /// Puts a shell script in place of the compiler; in its text, @ is the compiler and what the
    /// kit gives it.
    void wrap_compiler(const std::string& stage, const fs::path& script, std::string text) const {
        const std::string start = "compiler ";
        std::string options;
        for (const std::string& line : lines_of(read_text(kit(stage)))) {
            const bool names_it = line.starts_with(start);
            if (names_it) text.replace(text.find('@'), 1, line.substr(start.size()) + " \"$@\"");
            options += (names_it ? start + script.string() : line) + "\n";
        }
        write_text(kit(stage), options);
        write_script(script, text);
    }

    static void write_script(const fs::path& script, const std::string& text) {
        write_text(script, "#!/bin/sh\n" + text + "\n");
        fs::permissions(script, fs::perms(0755));
    }

    [[nodiscard]] grade::Build compiled(const std::string& stage, const std::string& text) const {
        return grade::compile_submission(workshop_, *find_stage(stage), text,
                                         folder_.path() / "submission.o");
    }

private:
    [[nodiscard]] fs::path kit(const std::string& stage) const {
        return folder_.path() / "seats" / (stage + ".txt");
    }

    TemporaryFolder folder_;
    TemporaryFolder beside_;
    grade::BuildDirectory workshop_;
};

const std::string sphere = "step03_sphere";

}  // namespace

TEST_CASE("headers in another folder are accessible to a compiler, if all users may read them") {
    const ChangedKits kits;
    write_text(kits.beside() / "deploy.hpp", "namespace elsewhere {}\n");
    kits.add(sphere, "-isystem" + kits.beside().string());
    const std::string text = "#include <deploy.hpp>\n" + reference(sphere);
    const grade::Build made = kits.compiled(sphere, text);
    INFO(made.words);
    CHECK(made.succeeded);
    if (geteuid() != 0) return;  // who compiles is who owns the place
    fs::permissions(kits.beside(), fs::perms(0700));
    const grade::Build closed = kits.compiled(sphere, text);
    CHECK_FALSE(closed.succeeded);
    CHECK(closed.words.find("Permission denied") != std::string::npos);
}

TEST_CASE(
    "of a compiler in ~/.local, a submission reads its own folders, and not those beside it") {
    const ChangedKits kits;
    const fs::path secret = kits.beside() / "share/keyring";
    const fs::path wrapper = kits.beside() / "bin/g++";
    for (const fs::path& each : {secret, wrapper}) fs::create_directory(each.parent_path());
    write_text(secret, "TOPSECRET\n");
    kits.wrap_compiler(sphere, wrapper, "exec @");
    const grade::Build made = kits.compiled(sphere, reference(sphere));
    INFO(made.words);
    CHECK(made.succeeded);
    const grade::Build read =
        kits.compiled(sphere, "#include \"" + secret.string() + "\"\n" + reference(sphere));
    CHECK_FALSE(read.succeeded);
    CHECK(read.words.find("TOPSECRET") == std::string::npos);
}

TEST_CASE("with g++, every file of functions is compiled once, from a valid precompiled header") {
    const ChangedKits kits;
    for (const std::string stage : {"step01_ray_generation", "step03_sphere", "step09_phong"}) {
        if (!kits.has(stage, "header")) continue;
        // A second compile has no -include.
        kits.wrap_compiler(
            stage, kits.beside() / "once",
            "case $* in *' -include '*) exec @ ;; esac\necho compiled again\nexit 1");
        for (const std::string& option :
             {"-Winvalid-pch"s, "-Werror"s, "-isystem" + kits.beside().string()})
            kits.add(stage, option);
        const grade::Build made = kits.compiled(stage, reference(stage));
        INFO(stage << ": " << made.words);
        CHECK(made.succeeded);
    }
}

TEST_CASE("a compiler that the system kills is no mark, whatever a submission makes it print") {
    const ChangedKits kits;
    if (!kits.has(sphere, "driver")) return;  // clang++ is one process
    ChangedKits::write_script(kits.beside() / "cc1plus", "ulimit -t 1\nwhile :; do :; done");
    kits.add(sphere, "-isystem" + kits.beside().string());
    kits.add(sphere, "-B" + kits.beside().string() + "/");
    CHECK_THROWS_AS(kits.compiled(sphere, reference(sphere)), ProgramError);
}

TEST_CASE("a file in UTF-16 or UTF-32 is recognized, with or without its first bytes") {
    const ChangedKits kits;
    for (const auto& [text, name] : {std::pair("\xff\xfe#\0i\0"s, "UTF-16, "s),
                                     {"\xfe\xff\0#\0i"s, "UTF-16, "},
                                     {"#\0i\0\n\0"s, "UTF-16, "},
                                     {"\0#\0i\0\n"s, "UTF-16, "},
                                     {"\xff\xfe\0\0#\0\0\0"s, "UTF-32, "},
                                     {"\0\0\xfe\xff\0\0\0#"s, "UTF-32, "},
                                     {"#\0\0\0i\0\0\0"s, "UTF-32, "}}) {
        const grade::Build made = kits.compiled(sphere, text);
        INFO(name);
        CHECK(made.words.find("Your file is encoded in " + name) == 0);
    }
}
