#include "common/course/grade/judging/ask_suite.hpp"

#include "common/course/build/suite_report.hpp"
#include "common/stages/stages.hpp"
#include "common/system/hash.hpp"
#include "common/system/input_error.hpp"

#include <fcntl.h>
#include <sched.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <random>

namespace rt::grade {

namespace {

// The limits of a worker. Right answers use at most a tenth of them. A case has less than the
// sandbox allows for a process, so that the client always ends it.
constexpr int answer_seconds = 5;
constexpr int case_seconds = 8;
constexpr int suite_seconds = 20;
// A suite that has computed for this long, with its workers, was kept from its end by them.
constexpr int most_processor_seconds = 10 * suite_seconds;

/// While it exists, the processes that this thread starts run on the processor that the thread is
/// on. A suite and its worker take turns: to wake the other on another, idle processor takes longer
/// than most answers. The next one may find another processor.
class OneProcessor {
public:
    OneProcessor() : found_(sched_getaffinity(0, sizeof before_, &before_) == 0) {
        const int here = sched_getcpu();
        if (!found_ || here < 0 || here >= CPU_SETSIZE) return;
        cpu_set_t one;
        CPU_ZERO(&one);
        CPU_SET(std::size_t(here), &one);
        sched_setaffinity(0, sizeof one, &one);
    }
    ~OneProcessor() {
        if (found_) sched_setaffinity(0, sizeof before_, &before_);
    }
    OneProcessor(const OneProcessor&) = delete;
    OneProcessor& operator=(const OneProcessor&) = delete;

private:
    cpu_set_t before_{};
    bool found_;
};

}  // namespace

ProcessResult run_asking(const Grading& grading, int stage, const Command& program,
                         const Command& variables) {
    Command command{"env", "-i"};
    for (const char* each : {"PATH", "LD_LIBRARY_PATH"})  // decide whether it runs, not its result
        if (const char* value = std::getenv(each))
            command.push_back(each + ("=" + std::string(value)));
    command.push_back("RAYSTEPS_SEALED=" + grading.workshop.sealed.string());
    command.push_back("RAYSTEPS_LIMITS=" + worker_limits(stage));
    command.insert(command.end(), variables.begin(), variables.end());
    command.push_back(grading.build / program.front());
    command.insert(command.end(), program.begin() + 1, program.end());
    const OneProcessor suite_and_worker;
    ProcessResult ending = run_captured(command, grading.longest_asking, grading.workshop.stop);
    go_on(grading.workshop);
    if (ending.out_of_time && ending.processor_seconds < most_processor_seconds)
        throw ProgramError(program.front() + ended_by_the_clock(ending));
    if (!ending.out_of_time && !ending.crash.empty() && is_stopped(ending.status))
        throw Interrupted();
    return ending;
}

std::vector<CaseMark> ask_suite(const Grading& grading, GradedFile graded, const fs::path& worker,
                                const Command& more_variables) {
    const fs::path report = worker.parent_path() / (name_of(graded) + ".report");
    Command variables{"RAYSTEPS_WORKER=" + worker.string(),
                      "RAYSTEPS_REPORT=" + report.string(),
                      "RAYSTEPS_SEED_FILE=" + seed_file(grading.results).string(),
                      "RAYSTEPS_SECONDS=" + std::to_string(answer_seconds),
                      "RAYSTEPS_CASE_SECONDS=" + std::to_string(case_seconds),
                      "RAYSTEPS_SUITE_SECONDS=" + std::to_string(suite_seconds)};
    variables.insert(variables.end(), more_variables.begin(), more_variables.end());
    const ProcessResult ending =
        run_asking(grading, graded.stage,
                   {name_of(graded) + "_asked_test_double", "--out", "/dev/null"}, variables);
    std::vector<CaseMark> cases;
    // No submission can end the suite; a system without memory can.
    if (!ending.out_of_time && !ending.crash.empty())
        throw ProgramError("the suite of " + name_of(graded) + " was ended: " + ending.crash);
    if (!fs::exists(report) && ending.out_of_time) return cases;
    if (!fs::exists(report))
        throw ProgramError("the suite of " + name_of(graded) + " does not run\n");
    const std::set<std::string> given =
        passed_by_starter(grading.project / "steps" / stage_name(graded.stage));
    for (const CaseResult& each : read_report(read_text(report)))
        cases.push_back({.name = each.name,
                         .points = each.points,
                         .passed = each.passed,
                         .given = given.count(each.name) == 1,
                         .of_trace = graded.is_trace,
                         .place = each.place,
                         .words = each.failure,
                         .failures = each.failures});
    fs::remove(report);
    return cases;
}

namespace {

constexpr std::size_t digits = 16;
constexpr std::size_t identifier_digits = 8;

std::string text_of(std::uint64_t number) {
    return formatted("%016llx", static_cast<unsigned long long>(number));
}

std::uint64_t random_bits() {
    std::random_device device;
    return std::uint64_t(device()) << 32 | device();
}

/// Gives the written file its name, unless another one has it: by a hard link, or by a renaming
/// where the disk has none (exFAT, some network disks). False, with errno, if neither works.
bool give_name(const fs::path& part, const fs::path& file) {
    return link(part.c_str(), file.c_str()) == 0 || errno == EEXIST ||
           renameat2(AT_FDCWD, part.c_str(), AT_FDCWD, file.c_str(), RENAME_NOREPLACE) == 0 ||
           errno == EEXIST;
}

/// Writes the seed whole, or leaves the one that is there.
void store(std::uint64_t seed, const fs::path& file) {
    const std::string text = text_of(seed) + "\n";
    const fs::path part = file.parent_path() / (".seed." + text_of(random_bits()));
    const int descriptor = open(part.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
    const auto fail = [&file](int error) {
        throw InputError({file}, std::string("cannot be written: ") + std::strerror(error));
    };
    if (descriptor == -1) fail(errno);
    const bool stored = write(descriptor, text.data(), text.size()) == ssize_t(text.size()) &&
                        fsync(descriptor) == 0 && give_name(part, file);
    const int error = errno;
    close(descriptor);
    unlink(part.c_str());
    if (!stored) fail(error);
}

}  // namespace

fs::path seed_file(const fs::path& results) {
    return results / "seed.txt";
}

std::uint64_t read_seed(const fs::path& file) {
    std::string text = read_text(file);
    std::erase_if(text, [](unsigned char c) { return std::isspace(c) != 0; });
    std::uint64_t seed = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, seed, 16);
    if (text.size() != digits || error != std::errc() || stop != end)
        throw InputError({file, 1, 1}, "not a seed: 16 hexadecimal digits were expected");
    return seed;
}

std::uint64_t agreed_seed(const fs::path& results, const std::optional<fs::path>& given) {
    const fs::path file = seed_file(results);
    const std::uint64_t proposed = given ? read_seed(*given) : random_bits();
    if (!fs::exists(file)) store(proposed, file);
    const std::uint64_t seed = read_seed(file);
    if (given && seed != proposed)
        throw InputError({file}, "is a different seed than " + given->string() +
                                     ": a run with another seed needs another --out");
    return seed;
}

std::string seed_identifier(std::uint64_t seed) {
    return text_of(keyed_hash({seed, 0}, "identifier of the seed")).substr(0, identifier_digits);
}

}  // namespace rt::grade
