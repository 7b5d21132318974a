#include "common/course/grade/results/changes.hpp"

#include "common/course/grade/results/csv.hpp"
#include "common/course/grade/results/student_names.hpp"

#include "common/stages/graded_file.hpp"
#include "common/stages/stages.hpp"
#include "common/system/files.hpp"
#include "common/system/input_error.hpp"

#include <ctime>
#include <fstream>
#include <mutex>

namespace rt::grade {

namespace {

namespace fs = std::filesystem;

constexpr const char* columns_of_changes = "date,student,stage,before,after,why";

/// The change of one of the files, by its hashes; empty if it is the same.
std::string change_of(GradedFile file, const std::string& before, const std::string& after) {
    if (before == after) return "";
    return file_name(file) + (before.empty()  ? " is new"
                              : after.empty() ? " is missing"
                                              : " is another");
}

std::string why(const Mark& before, const Mark& after) {
    if (after.key.empty()) return "could not be graded; it will be judged again";
    if (before.key.empty()) return "could not be graded before";
    const std::string file = change_of(after.stage, before.source, after.source);
    const std::string trace =
        change_of({after.stage, true}, before.trace_source, after.trace_source);
    if (!file.empty() || !trace.empty())
        return file + (file.empty() || trace.empty() ? "" : ", ") + trace;
    return "the same files: the suite, a reference or the seed has changed";
}

}  // namespace

std::string today() {
    const char* given = std::getenv("SOURCE_DATE_EPOCH");
    const std::time_t now = given == nullptr ? std::time(nullptr) : std::atoll(given);
    std::tm day{};
    char text[16];
    if (localtime_r(&now, &day) == nullptr || std::strftime(text, sizeof text, "%F", &day) == 0)
        return "";
    return text;
}

void record_change(const fs::path& results, const Mark& before, const Mark& after) {
    if (before.points() == after.points()) return;
    static std::mutex mutex;
    const std::lock_guard lock(mutex);
    const fs::path file = results / changes_file;
    std::ofstream out(file, std::ios::app | std::ios::binary);
    const std::string line = today() + "," + cell(after.student) + "," + name_of(after.stage) +
                             "," + std::to_string(before.points()) + "," +
                             std::to_string(after.points()) + "," + cell(why(before, after)) +
                             end_of_line;
    const bool is_new = size_of_changes(results) == 0;
    out << (is_new ? columns_of_changes + (end_of_line + line) : line) << std::flush;
    if (!out) throw InputError({file.string()}, "cannot be written");
}

std::uintmax_t size_of_changes(const fs::path& results) {
    std::error_code none;
    const std::uintmax_t size = fs::file_size(results / changes_file, none);
    return none ? 0 : size;
}

std::vector<std::string> changes_since(const fs::path& results, std::uintmax_t size) {
    if (size_of_changes(results) <= size) return {};
    std::vector<std::string> lines = lines_of(read_text(results / changes_file).substr(size));
    for (std::string& line : lines) line = trimmed(line);
    if (size == 0 && !lines.empty()) lines.erase(lines.begin());  // the headings
    return lines;
}

}  // namespace rt::grade
