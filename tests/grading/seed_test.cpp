// The seed of a graded run: agreed on once, readable by nobody else, in no report.
#include "common/course/grade/judging/seed.hpp"
#include "common/system/files.hpp"
#include "common/system/process.hpp"

#include "common/system/input_error.hpp"

#include "tests/kit/catch.hpp"

#include <seccomp.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <set>
#include <thread>

using namespace rt;

namespace fs = std::filesystem;

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
