// The version that programs print.
#include "common/system/version.hpp"
#include "common/system/files.hpp"

#include "tests/kit/catch.hpp"

using namespace rt;

TEST_CASE("a version names the commit of a clone, or the one of which a hand-out was made") {
    const TemporaryFolder folder;
    const auto& project = folder.path();
    CHECK(version(project) == version_number());
    write_text(project / ".git/HEAD", "ref: refs/heads/main\n");
    write_text(project / ".git/packed-refs", "# pack-refs\n0123456789abcdef refs/heads/main\n");
    CHECK(version(project) == version_number() + " (0123456)");
    write_text(project / ".git/refs/heads/main", "89abcdef01234567\n");
    CHECK(version(project) == version_number() + " (89abcde)");

    // A student's commit is none of the project's.
    const auto manifest = project / "steps/handout.txt";
    write_text(manifest,
               "Raysteps, version 1.0.0 (52c7ed4), handed out on 2026-11-21 for g++ (12)\n");
    CHECK(version(project) == version_number() + " (52c7ed4)");
    write_text(manifest, "Raysteps, version 1.0.0, handed out on 2026-11-21 for g++ (12)\n");
    CHECK(version(project) == version_number());
    write_text(manifest, "Raysteps, half updated: run ./course update again\n");
    CHECK(version(project) == version_number());
}
