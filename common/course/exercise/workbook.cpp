#include "common/course/exercise/workbook.hpp"

#include "common/course/build/project.hpp"
#include "common/system/hash.hpp"
#include "common/system/input_error.hpp"
#include "common/system/translation.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <sstream>

namespace rt {

namespace {

constexpr const char* progress_file = "progress.txt";
constexpr int scene_stage = 2;  // the reader of scenes calls it, in stage 1 too

/// "key: value" lines.
Record read_record(const fs::path& file) {
    Record record;
    if (!fs::exists(file)) return record;
    for (const std::string& line : lines_of(read_text(file))) {
        const std::size_t colon = line.find(": ");
        if (colon == std::string::npos) continue;
        const std::string key = line.substr(0, colon);
        const std::string value = line.substr(colon + 2);
        std::istringstream number(value);
        std::string of;
        if (key == "checked") record.checked = value;
        if (key == "passed") number >> record.passed >> of >> record.cases;
        if (key == "files") record.checked_files = value;
        if (key == "part") record.part = value;
        if (key == "hints") number >> record.hints;
        if (key == "hint part") record.hint_part = value;
        if (key == "hint level") number >> record.hint_level;
        if (key == "solution asked") number >> record.solution_asked;
    }
    return record;
}

std::string text(const Record& record) {
    std::ostringstream out;
    out << "# The progress of this stage, as stored by ./course. Remove this file to reset it.\n";
    if (!record.checked.empty())
        out << "checked: " << record.checked << "\npassed: " << record.passed << " of "
            << record.cases << "\nfiles: " << record.checked_files << '\n';
    if (!record.part.empty()) out << "part: " << record.part << '\n';
    if (record.hints > 0)
        out << "hints: " << record.hints << "\nhint part: " << record.hint_part
            << "\nhint level: " << record.hint_level << '\n';
    if (record.solution_asked > 0) out << "solution asked: " << record.solution_asked << '\n';
    return out.str();
}

/// The position of the end of the comment at the start of a source file.
std::size_t end_of_first_comment(const std::string& source) {
    std::size_t end = 0;
    while (source.compare(end, 2, "//") == 0)
        end = std::min(source.find('\n', end), source.size() - 1) + 1;
    return end;
}

/// The starter's trace_file, or the student's own of the stage before under its first comment.
std::string trace_to_go_on_from(const fs::path& starter, int stage) {
    const std::string fresh = read_text(starter);
    if (stage == 1) return fresh;
    const fs::path before = project_folder / step_path(stage - 1, "student") / trace_file;
    if (!fs::exists(before)) return fresh;
    const std::string own = read_text(before);
    return fresh.substr(0, end_of_first_comment(fresh)) + own.substr(end_of_first_comment(own));
}

}  // namespace

Workbook::Workbook(int stage)
    : stage_(stage),
      folder_(project_folder / step_path(stage, "student")),
      record_(read_record(folder_ / progress_file)) {}

std::vector<fs::path> Workbook::files() const {
    return files_in(folder_, ".cpp");
}

bool Workbook::has_trace() const {
    return fs::exists(folder_ / trace_file);
}

State Workbook::state() const {
    if (files().empty()) return State::untouched;
    const bool passed = record_.cases > 0 && record_.passed == record_.cases;
    return passed && record_.checked_files == fingerprint() ? State::done : State::started;
}

std::string Workbook::verdict() const {
    if (files().empty()) return "";
    if (record_.checked.empty()) return tr("not checked yet");
    if (state() != State::done && record_.passed == record_.cases)
        return tr("changed since it passed");
    const Values values = {{"passed", record_.passed}, {"cases", record_.cases}};
    const bool is_changed = record_.checked_files != fingerprint();
    return is_changed ? tr("changed since {passed} of {cases} cases passed", values)
                      : tr("{passed} of {cases} cases pass", values);
}

std::string Workbook::summary() const {
    if (record_.hints == 0) return verdict();
    if (record_.hints == 1) return verdict() + ", " + tr("1 hint");
    return verdict() + ", " + tr("{number} hints", {{"number", record_.hints}});
}

std::string Workbook::fingerprint() const {
    std::uint64_t all = fnv1a("");
    for (const fs::path& folder : {folder_, folder_ / "tests"})
        for (const fs::path& file : files_in(folder, ".cpp"))
            all = fnv1a(read_text(file), fnv1a(file.filename().string(), all));
    std::ostringstream out;
    out << std::hex << all;
    return out.str();
}

void Workbook::remember(const Record& record) {
    std::error_code there;
    fs::create_directories(folder_, there);
    write_text(folder_ / progress_file, text(record));
    record_ = record;
}

void Workbook::start() {
    if (!files().empty())
        throw InputError({}, tr("{folder} exists already: ./course reset {number} keeps it and "
                                "copies the starter again",
                                {{"folder", step_path(stage_, "student")}, {"number", stage_}}));
    std::error_code there;
    fs::create_directories(folder_, there);
    const TemporaryFolder workshop(folder_.parent_path());
    for (const fs::path& file : files_in(fresh_start(workshop.path()), ".cpp"))
        fs::rename(file, folder_ / file.filename());
}

std::string Workbook::reset() {
    if (files().empty())
        throw InputError({}, tr("nothing to reset: ./course start {number}", {{"number", stage_}}));
    const TemporaryFolder workshop(folder_.parent_path());
    const fs::path fresh = fresh_start(workshop.path());
    int number = 1;
    std::string kept;
    do {
        kept = step_path(stage_, "student_" + std::to_string(number++));
    } while (fs::exists(project_folder / kept));
    fs::rename(folder_, project_folder / kept);
    fs::rename(fresh, folder_);
    record_ = {};
    return kept;
}

fs::path Workbook::fresh_start(const fs::path& workshop) const {
    fs::path fresh = workshop / folder_.filename();
    fs::create_directory(fresh);
    for (const fs::path& file : files_in(project_folder / step_path(stage_, "starter"), ".cpp"))
        write_text(fresh / file.filename(), file.filename() == trace_file
                                                ? trace_to_go_on_from(file, stage_)
                                                : read_text(file));
    return fresh;
}

InputError not_started(int stage) {
    return {{},
            tr("{stage} is not started: ./course start {number}",
               {{"stage", name_of(stage)}, {"number", stage}})};
}

int current_stage() {
    std::optional<int> untouched;
    int last = 1;
    for (int stage = 1; stage <= int(stage_names.size()); ++stage) {
        if (!is_here(stage)) continue;
        last = stage;
        const State state = Workbook(stage).state();
        if (state == State::started) return stage;
        if (state == State::untouched && !untouched) untouched = stage;
    }
    return untouched.value_or(last);
}

std::optional<int> next_stage(int stage) {
    if (stage == int(stage_names.size()) || !is_here(stage + 1)) return std::nullopt;
    return stage + 1;
}

std::vector<int> started_before(int stage) {
    std::vector<int> started;
    for (int other = 1; other < std::max(stage, scene_stage + 1); ++other)
        if (other != stage && Workbook(other).state() != State::untouched) started.push_back(other);
    return started;
}

}  // namespace rt
