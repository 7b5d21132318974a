// A suite that something else ends: the grader's failure, and no mark.
#include "common/course/grade/judging/ask_suite.hpp"
#include "common/system/files.hpp"

#include "tests/kit/catch.hpp"

using namespace rt;

namespace fs = std::filesystem;

namespace {

/// Marks a submission by a suite that reaches its first case, and then gets the signal.
std::vector<grade::CaseMark> marked_until(const std::string& signal) {
    const TemporaryFolder folder;
    const fs::path suite = folder.path() / "step03_sphere_asked_test_double";
    write_text(suite, "#!/bin/sh\necho 'case a' > \"$RAYSTEPS_REPORT\"\nkill -" + signal + " $$\n");
    fs::permissions(suite, fs::perms(0755));
    const grade::Grading grading{
        .project = folder.path(), .build = folder.path(), .results = folder.path()};
    return grade::ask_suite(grading, 3, folder.path() / "worker",
                            std::chrono::steady_clock::now() + std::chrono::minutes(1));
}

}  // namespace

TEST_CASE("a suite that the system ends is no verdict on a submission") {
    CHECK(marked_until("0").size() == 1);
    CHECK_THROWS_WITH(marked_until("KILL"), "the suite of step03_sphere was ended: Killed");
    CHECK_THROWS_AS(marked_until("TERM"), grade::Interrupted);
}
