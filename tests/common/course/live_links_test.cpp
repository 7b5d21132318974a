// Pages of a hand-out, which leaves out files that the project's pages lead to.
#include "common/course/handout/live_links.hpp"

#include "common/system/files.hpp"

#include "tests/kit/catch.hpp"

#include <filesystem>

using namespace rt;

TEST_CASE("a link to a file that a hand-out leaves out becomes its text") {
    const TemporaryFolder project;
    const std::filesystem::path docs = project.path() / "docs";
    std::filesystem::create_directories(docs / "pictures");
    write_text(project.path() / "README.md", "");
    write_text(docs / "pictures/a.png", "");
    CHECK(with_live_links("[a](../tests/a.cpp), [b](../README.md), [`c`](pictures/c.md#d).\n"
                          "![picture](pictures/a.png)",
                          docs) == "a, [b](../README.md), `c`.\n![picture](pictures/a.png)");
    const std::string kept =
        "[a](https://host/x/y), [b](#place), [&](const Real& a / b), x[i](y), ](a/b) [a](b/c";
    CHECK(with_live_links(kept, docs) == kept);
}
