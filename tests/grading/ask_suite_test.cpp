// The grader runs a suite and its worker on one processor. If something else ends the suite, the
// grader has failed, and gives no mark.
#include "common/course/grade/judging/ask_suite.hpp"
#include "common/system/files.hpp"

#include "tests/kit/catch.hpp"

#include <sched.h>

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

std::chrono::steady_clock::time_point in_a_minute() {
    return std::chrono::steady_clock::now() + std::chrono::minutes(1);
}

/// Marks a submission by a suite that reaches its first case, and then gets the signal.
std::vector<grade::CaseMark> marked_until(const std::string& signal) {
    const BuildOfOne build("step03_sphere_asked_test_double",
                           "echo 'case a' > \"$RAYSTEPS_REPORT\"\nkill -" + signal + " $$\n");
    return grade::ask_suite(build.grading(), 3, build.folder() / "worker", in_a_minute());
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
    CHECK(grade::run_asking(build.grading(), 3, {"counts"}, {}, in_a_minute()).output == "1\n");
    CHECK(processors() == before);
}
