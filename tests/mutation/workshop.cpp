#include "tests/mutation/workshop.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <stdexcept>

namespace mutation {

namespace {

[[noreturn]] void become(const std::vector<std::string>& words, int seconds) {
    const rlimit limit{.rlim_cur = rlim_t(seconds), .rlim_max = rlim_t(seconds)};
    setrlimit(RLIMIT_CPU, &limit);  // a mutant may loop
    const rlimit none{};
    setrlimit(RLIMIT_CORE, &none);
    const int nowhere = open("/dev/null", O_RDWR);
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) dup2(nowhere, stream);
    std::vector<char*> arguments;
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    execvp(arguments[0], arguments.data());
    _exit(127);
}

struct Run {
    bool succeeded = false;
    double seconds = 0;  ///< of processor time
};

Run run(const std::vector<std::string>& words, int seconds) {
    const pid_t child = fork();
    if (child == 0) become(words, seconds);
    int status = 0;
    rusage usage{};
    if (child < 0 || wait4(child, &status, 0, &usage) != child)
        throw std::runtime_error("cannot run " + words.front());
    const timeval used = usage.ru_utime;
    return {.succeeded = status == 0, .seconds = double(used.tv_sec) + 1e-6 * double(used.tv_usec)};
}

/// Runs the compiler, without its warnings about a mutant.
bool compiles(const std::filesystem::path& options, const std::vector<std::string>& more) {
    std::vector<std::string> words = {RAYSTEPS_COMPILER, "@" + options.string(), "-w"};
    words.insert(words.end(), more.begin(), more.end());
    return run(words, 60).succeeded;
}

std::string includes_of(const std::string& source) {
    std::istringstream lines(source);
    std::string includes;
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with("#include")) includes += line + '\n';
    return includes;
}

/// The cases that a suite's report names, but those that passed if they are not wanted. A case that
/// it does not end crashed or took too long.
std::vector<std::string> cases_in(const std::filesystem::path& report, bool passed_too) {
    std::vector<std::string> cases;
    if (!std::filesystem::exists(report)) return cases;
    std::istringstream lines(rt::read_text(report));
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("case ")) cases.push_back(line.substr(5));
        if (line == "passed" && !passed_too) cases.pop_back();
    }
    return cases;
}

}  // namespace

BuildDirectory::BuildDirectory(const std::string& stage, const std::string& reference,
                               bool every_case) {
    const std::filesystem::path folder = RAYSTEPS_MUTATION_FOLDER;
    if (!every_case) suite_options_ = {"--abort"};
    setenv("RAYSTEPS_REPORT", report_.c_str(), 1);
    // found before the reference's library, whose path is built in
    setenv("LD_LIBRARY_PATH", work_.path().c_str(), 1);
    for (const auto& [word, name] :
         {std::pair<std::string, std::string>{"double", "f64"}, {"float", "f32"}}) {
        precisions_.push_back(
            {.options = folder / (stage + "_" + name + ".options"),
             .prelude = work_.path() / (name + ".hpp"),
             .library = work_.path() / ("lib" + stage + "_mutant_" + name + ".so"),
             .suite = folder / (stage + "_mutant_test_" + word)});
    }
    double slowest = 0;
    for (Precision& precision : precisions_) {
        prepare(precision, reference);
        const Run judged = run({precision.suite}, seconds_);
        cases_ = cases_in(report_, true);
        if (!judged.succeeded) throw std::runtime_error(stage + ": the reference does not pass");
        slowest = std::max(slowest, judged.seconds);
    }
    seconds_ = int(std::ceil(2 + 5 * slowest));
}

void BuildDirectory::prepare(Precision& precision, const std::string& reference) {
    rt::write_text(precision.prelude, includes_of(reference));
    const std::string prelude = precision.prelude;
    if (!compiles(precision.options, {"-x", "c++-header", prelude, "-o", prelude + ".gch"}) ||
        !compile(precision, reference))
        throw std::runtime_error("the reference does not compile");
    precision.code_of_reference = rt::read_text(precision.library);
}

bool BuildDirectory::compile(const Precision& precision, const std::string& source) const {
    rt::write_text(source_, source);
    return compiles(precision.options,
                    {"-include", precision.prelude, "-shared", source_, "-o", precision.library});
}

Outcome BuildDirectory::judge(const Precision& precision, const std::string& source) const {
    if (!compile(precision, source)) return {.fate = Fate::not_compiled, .killers = {}};
    if (rt::read_text(precision.library) == precision.code_of_reference)
        return {.fate = Fate::same_code, .killers = {}};
    std::vector<std::string> words = {precision.suite};
    words.insert(words.end(), suite_options_.begin(), suite_options_.end());
    std::filesystem::remove(report_);
    if (run(words, seconds_).succeeded) return {.fate = Fate::survived, .killers = {}};
    return {.fate = Fate::killed, .killers = cases_in(report_, false)};
}

Outcome BuildDirectory::judge(const std::string& source) const {
    for (const Precision& precision : precisions_) {
        Outcome outcome = judge(precision, source);
        if (outcome.fate != Fate::survived) return outcome;
    }
    return {.fate = Fate::survived, .killers = {}};
}

}  // namespace mutation
