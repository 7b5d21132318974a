#include "common/course/book/own_answers.hpp"

#include "common/course/build/build.hpp"
#include "common/course/build/compiler_errors.hpp"
#include "common/course/build/project.hpp"
#include "common/system/process.hpp"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <mutex>
#include <set>

namespace rt {

namespace fs = std::filesystem;

namespace {

constexpr std::chrono::seconds answer_limit{30};  // call_once has a shorter one, of computing time
constexpr std::size_t longest_question = 4096;    // in digits

/// The names and the times of the student's files of a stage; empty if there are none.
std::string state_of_files(int stage) {
    std::set<std::string> files;
    std::error_code none;
    for (const auto& entry :
         fs::directory_iterator(project_folder / step_path(stage, "student"), none))
        if (entry.path().extension() == ".cpp" && entry.path().filename() != trace_file)
            files.insert(entry.path().string() + " " +
                         std::to_string(
                             std::int64_t(entry.last_write_time(none).time_since_epoch().count())) +
                         "\n");
    std::string state;
    for (const std::string& file : files) state += file;
    return state;
}

/// The last build of a worker.
struct Built {
    std::string from;
    std::string error;
};

/// Builds the worker if its files have changed. Throws Refusal with the first error.
void bring_up_to_date(int stage, const std::string& worker) {
    static std::mutex one_at_a_time;
    static std::map<std::string, Built> built;
    const std::scoped_lock lock(one_at_a_time);
    const std::string files = state_of_files(stage);
    if (files.empty())
        throw Refusal{422, "nothing is started: ./course start " + std::to_string(stage)};
    Built& last = built[worker];
    if (last.from != files) {
        const Build build = try_build({"call_once", worker});
        last = {.from = files, .error = build.succeeded ? "" : first_error(build.output)};
    }
    if (!last.error.empty()) throw Refusal{422, last.error};
}

std::string question_of(const Request& request, int stage) {
    const auto found = request.parameters.find("question");
    const std::string digits = found == request.parameters.end() ? "" : found->second;
    if (digits.size() < 4 || digits.size() % 2 != 0 || digits.size() > longest_question ||
        digits.find_first_not_of("0123456789abcdef") != std::string::npos)
        throw Refusal{400, "question: expected an even number of hexadecimal digits, 4 to " +
                               std::to_string(longest_question)};
    if (std::stoi(digits.substr(0, 2), nullptr, 16) != stage)
        throw Refusal{400, "question: expected one to stage " + std::to_string(stage)};
    return digits;
}

std::string bytes_of(const std::string& digits) {
    std::string bytes;
    for (std::size_t i = 0; i + 1 < digits.size(); i += 2)
        bytes += char(std::stoi(digits.substr(i, 2), nullptr, 16));
    return bytes;
}

}  // namespace

Response own_answer_address() {
    return {.body =
                "export const mine = \"../../../own_answer\";\n"
                "export const files = \"../../../own_files\";\n",
            .type = "text/javascript"};
}

Response own_files() {
    std::string all;
    for (int stage = 1; stage <= int(stage_names.size()); ++stage) all += state_of_files(stage);
    return {.body = all, .type = "text/plain; charset=utf-8"};
}

Response own_answer(const Request& request, const std::atomic<bool>& cancelled) {
    const int stage = whole_number(request, "stage", 1, int(stage_names.size()));
    const bool is_float = whole_number(request, "precision", 0, 1) == 1;
    const std::string question = question_of(request, stage);
    const std::string worker = stage_target(stage, is_float ? "_worker_float" : "_worker_double");
    bring_up_to_date(stage, worker);
    const ProcessResult called = run_captured(
        {(build_folder / "call_once").string(), (build_folder / worker).string(), question},
        answer_limit, &cancelled);
    if (called.out_of_time) throw Refusal{422, "your code gave no answer within 30 s"};
    const std::string printed = called.output.substr(0, called.output.find('\n'));
    if (called.status != 0) throw Refusal{422, printed};
    return {.body = bytes_of(printed), .type = "application/octet-stream"};
}

}  // namespace rt
