// The grader runs a suite and its worker on one processor. If something else ends the suite, the
// grader has failed, and gives no mark; so it has if the clock ends it.
#include "common/course/grade/judging/ask_suite.hpp"
#include "common/system/files.hpp"

#include "tests/kit/catch.hpp"

#include <sched.h>

#include <cstdlib>

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
