// The grader runs a suite and its worker on one processor. If something else ends the suite, the
// grader has failed, and gives no mark; so it has if the clock ends it.
#include "common/course/grade/judging/ask_suite.hpp"

#include "common/system/files.hpp"
#include "common/system/input_error.hpp"
#include "common/system/process.hpp"

#include "tests/kit/catch.hpp"

#include <sched.h>
#include <seccomp.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <set>
#include <thread>

using namespace rt;

namespace fs = std::filesystem;

namespace {

/// A build whose only program is a shell script.
class BuildOfOne {
public:
    BuildOfOne(const std::string& program, const std::string& script) {
        write_text(folder_.path() / program, "#!/bin/sh\n" + script);
        fs::permissions(folder_.path() / program, fs::perms(0755));
    }

    [[nodiscard]] fs::path folder() const { return folder_.path(); }
    [[nodiscard]] grade::Grading grading() const {
        return {.project = folder(), .build = folder(), .results = folder()};
    }

private:
    TemporaryFolder folder_;
};

/// Marks a submission by a suite that reaches its first case, and then gets the signal.
std::vector<grade::CaseMark> marked_until(const std::string& signal) {
    const BuildOfOne build("step03_sphere_asked_test_double",
                           "echo 'case a' > \"$RAYSTEPS_REPORT\"\nkill -" + signal + " $$\n");
    return grade::ask_suite(build.grading(), 3, build.folder() / "worker");
}

/// The number of processors that this thread may run on.
int processors() {
    cpu_set_t all;
    REQUIRE(sched_getaffinity(0, sizeof all, &all) == 0);
    return CPU_COUNT(&all);
}

}  // namespace

TEST_CASE("a suite that the system ends is no verdict on a submission") {
    CHECK(marked_until("0").size() == 1);
    CHECK_THROWS_WITH(marked_until("KILL"), "the suite of step03_sphere was ended: Killed");
    CHECK_THROWS_AS(marked_until("TERM"), grade::Interrupted);
}

TEST_CASE("a suite and its worker run on one processor, what comes after them on any") {
    const BuildOfOne build("counts", "nproc\n");
    const int before = processors();
    CHECK(grade::run_asking(build.grading(), 3, {"counts"}, {}).output == "1\n");
    CHECK(processors() == before);
}

TEST_CASE("a suite that the clock ends, though it has computed little, is no verdict") {
    const BuildOfOne build("step03_sphere_asked_test_double",
                           "echo 'case a' > \"$RAYSTEPS_REPORT\"\nkill -STOP $$\n");
    grade::Grading grading = build.grading();
    grading.longest_asking = std::chrono::seconds(1);
    std::string why;
    try {
        (void)grade::ask_suite(grading, 3, build.folder() / "worker");
    } catch (const ProgramError& error) {
        why = error.what();
    }
    CHECK(why.find("was ended by the clock") != std::string::npos);
}

TEST_CASE("no variable of the lecturer's changes what a suite does") {
    const BuildOfOne build("prints", "env\n");
    setenv("RAYSTEPS_AS_WRITTEN", "1", 1);
    setenv("MALLOC_PERTURB_", "1", 1);
    const std::string seen =
        grade::run_asking(build.grading(), 3, {"prints"}, {"RAYSTEPS_SECONDS=5"}).output;
    unsetenv("RAYSTEPS_AS_WRITTEN");
    unsetenv("MALLOC_PERTURB_");
    CHECK(seen.find("RAYSTEPS_SECONDS=5") != std::string::npos);
    CHECK(seen.find("RAYSTEPS_AS_WRITTEN") == std::string::npos);
    CHECK(seen.find("MALLOC_PERTURB_") == std::string::npos);
}

// The seed of a graded run: agreed on once, readable by nobody else, in no report.

namespace {

std::string error_of(const fs::path& results, const std::optional<fs::path>& given) {
    try {
        (void)grade::agreed_seed(results, given);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("the seed of a folder of results is made once, and readable by its owner only") {
    const TemporaryFolder first;
    const std::uint64_t seed = grade::agreed_seed(first.path(), {});
    CHECK(grade::agreed_seed(first.path(), {}) == seed);
    const fs::perms readers = fs::status(grade::seed_file(first.path())).permissions();
    CHECK(readers == (fs::perms::owner_read | fs::perms::owner_write));
    CHECK(std::distance(fs::directory_iterator(first.path()), fs::directory_iterator()) == 1);
    // All of its 64 bits are drawn.
    std::uint64_t once = seed;
    std::uint64_t always = seed;
    for (int i = 0; i < 40; ++i) {
        const TemporaryFolder other;
        const std::uint64_t agreed = grade::agreed_seed(other.path(), {});
        once |= agreed;
        always &= agreed;
    }
    CHECK(once == ~std::uint64_t(0));
    CHECK(always == 0);
}

TEST_CASE("runs that start at the same time agree on one seed") {
    for (int round = 0; round < 20; ++round) {
        const TemporaryFolder results;
        std::array<std::uint64_t, 8> seeds{};
        std::vector<std::thread> runs;
        for (std::uint64_t& seed : seeds)
            runs.emplace_back([&] { seed = grade::agreed_seed(results.path(), {}); });
        for (std::thread& run : runs) run.join();
        CHECK(std::set<std::uint64_t>(seeds.begin(), seeds.end()).size() == 1);
    }
}

TEST_CASE("a seed is agreed on where a disk has no hard links") {
    const TemporaryFolder results;
    const pid_t run = fork();
    if (run == 0) {  // where link fails, as on exFAT
        const scmp_filter_ctx filter = seccomp_init(SCMP_ACT_ALLOW);
        for (const int call : {SCMP_SYS(link), SCMP_SYS(linkat)})
            seccomp_rule_add_array(filter, SCMP_ACT_ERRNO(EPERM), call, 0, nullptr);
        if (seccomp_load(filter) != 0) _exit(2);
        const std::uint64_t seed = grade::agreed_seed(results.path(), {});
        _exit(grade::agreed_seed(results.path(), {}) == seed ? 0 : 1);
    }
    int status = -1;
    waitpid(run, &status, 0);
    CHECK(status == 0);
    CHECK(std::distance(fs::directory_iterator(results.path()), fs::directory_iterator()) == 1);
}

TEST_CASE("a seed is given by a file, which no other may follow") {
    const TemporaryFolder folder;
    const fs::path given = folder.path() / "given";
    const fs::path results = folder.path() / "results";
    fs::create_directory(results);
    write_text(given, " 00c0ffee12345678\n");
    CHECK(grade::agreed_seed(results, given) == 0xc0ffee12345678);
    CHECK(grade::agreed_seed(results, given) == 0xc0ffee12345678);
    CHECK(grade::agreed_seed(results, {}) == 0xc0ffee12345678);
    write_text(given, "00c0ffee12345679\n");
    CHECK(error_of(results, given).find("is a different seed than") != std::string::npos);
    CHECK(grade::agreed_seed(results, {}) == 0xc0ffee12345678);
    for (const char* text :
         {"", "7", "00c0ffee1234567g", "00c0ffee123456789", "-0c0ffee12345678"}) {
        write_text(given, text);
        const TemporaryFolder other;
        INFO(text);
        CHECK(error_of(other.path(), given).find(given.string() + ":1:1: error: not a seed") == 0);
        CHECK(fs::is_empty(other.path()));
    }
    fs::remove(given);
    const TemporaryFolder other;
    CHECK(!error_of(other.path(), given).empty());
}

TEST_CASE("a seed is identified by digits that do not reveal it") {
    CHECK(grade::seed_identifier(1).size() == 8);
    CHECK(grade::seed_identifier(1) != grade::seed_identifier(2));
    CHECK(grade::seed_identifier(1).find("00000") == std::string::npos);
}

TEST_CASE("a graded suite reveals the seed in no message") {
    const TemporaryFolder folder;
    const fs::path file = folder.path() / "seed.txt";
    const fs::path report = folder.path() / "report";
    write_text(file, "00000000000d15ea\n");  // 857578
    const auto reported = [&](const std::string& variable) {
        (void)run_captured(
            {"env", variable, "RAYSTEPS_WORKER=" RAYSTEPS_WRONG,
             "RAYSTEPS_REPORT=" + report.string(), RAYSTEPS_SUITE, "--out", "/dev/null"},
            std::chrono::seconds(60));
        return read_text(report);
    };
    const std::string graded = reported("RAYSTEPS_SEED_FILE=" + file.string());
    CHECK(graded.find("\n|   random:   case ") != std::string::npos);
    for (const char* secret : {"857578", "d15ea", "D15EA", "SEED"})
        CHECK(graded.find(secret) == std::string::npos);
    // A student's run is for repeating.
    CHECK(reported("RAYSTEPS_SEED=857578").find("random:   RAYSTEPS_SEED=857578, case ") !=
          std::string::npos);
    // Without its seed no input is generated.
    CHECK(reported("RAYSTEPS_SEED_FILE=/none").find("\ncase ") == std::string::npos);
}
