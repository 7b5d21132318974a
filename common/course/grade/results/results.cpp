#include "common/course/grade/results/results.hpp"

#include "common/course/grade/results/csv.hpp"
#include "common/course/grade/results/sha256.hpp"
#include "common/course/grade/results/student_names.hpp"
#include "common/stages/graded_file.hpp"
#include "common/stages/stages.hpp"
#include "common/system/input_error.hpp"
#include "common/system/version.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <fstream>
#include <mutex>
#include <set>
#include <utility>

namespace rt::grade {

namespace {

using Json = nlohmann::ordered_json;  // the same mark is the same bytes

constexpr int format = 1;
constexpr const char* students_folder = "students";
constexpr std::array verdicts{"missing", "refused", "judged", "postponed"};

/// One line of JSON; bytes that are not UTF-8, which untrusted code may print, become "�".
std::string line(const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

/// The first line contains the number of cases, so that a truncated file is recognized.
Json head(const Mark& mark) {
    Json json{{"raysteps", format},
              {"student", mark.student},
              {"stage", mark.stage},
              {"key", mark.key},
              {"verdict", verdicts.at(std::size_t(mark.verdict))},
              {"words", mark.words},
              {"source", mark.source},
              {"trace_source", mark.trace_source},
              {"mistake", mark.mistake},
              {"smallest", mark.smallest},
              {"slice", mark.slice},
              {"most", mark.most},
              {"cases", mark.cases.size()}};
    if (mark.picture)
        json["picture"] = {{"pixels", mark.picture->pixels},
                           {"different", mark.picture->different},
                           {"file", mark.picture->file}};
    return json;
}

Json to_json(const CaseMark& each) {
    return {{"name", each.name},   {"points", each.points},  {"passed", each.passed},
            {"given", each.given}, {"trace", each.of_trace}, {"place", each.place},
            {"words", each.words}};
}

Verdict verdict(const std::string& name) {
    const auto found = std::ranges::find(verdicts, name);
    if (found == verdicts.end()) throw InputError({}, "no verdict: " + name);
    return Verdict(found - verdicts.begin());
}

Mark read_head(const Json& json) {
    Mark mark{.student = json.at("student"),
              .stage = json.at("stage"),
              .key = json.at("key"),
              .verdict = verdict(json.at("verdict")),
              .words = json.at("words"),
              .source = json.at("source"),
              .trace_source = json.at("trace_source"),
              .mistake = json.at("mistake"),
              .smallest = json.at("smallest"),
              .slice = json.at("slice"),
              .most = json.at("most")};
    if (const auto picture = json.find("picture"); picture != json.end())
        mark.picture = PictureMark{.pixels = picture->at("pixels"),
                                   .different = picture->at("different"),
                                   .file = picture->at("file")};
    return mark;
}

CaseMark read_case(const Json& json) {
    return {.name = json.at("name"),
            .points = json.at("points"),
            .passed = json.at("passed"),
            .given = json.at("given"),
            .of_trace = json.at("trace"),
            .place = json.at("place"),
            .words = json.at("words")};
}

/// Throws if it is not a complete mark.
Mark read_lines(const std::string& text, const fs::path& file) {
    const std::vector<std::string> lines = lines_of(text);
    const Json first = Json::parse(lines.empty() ? "" : lines.front());
    const bool whole = text.back() == '\n' && first.at("raysteps") == format &&
                       first.at("cases") == lines.size() - 1;
    if (!whole) throw InputError({file.string()}, "is incomplete");
    Mark mark = read_head(first);
    for (std::size_t i = 1; i < lines.size(); ++i)
        mark.cases.push_back(read_case(Json::parse(lines[i])));
    return mark;
}

bool has_feedback_alone(const fs::path& folder) {
    std::error_code none;
    fs::directory_iterator each(folder, none);
    return each != fs::directory_iterator() && each->path().filename() == feedback_file &&
           ++each == fs::directory_iterator();
}

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

constexpr const char* classes_file = ".classes";

std::string line_of(const fs::path& place, const std::string& student) {
    return sha256(fs::canonical(place).string()) + " " + student;
}

bool contains(const std::vector<std::string>& classes, const std::string& line) {
    return std::ranges::find(classes, line) != classes.end();
}

}  // namespace

int Mark::points() const {
    return points(false) + points(true);
}

int Mark::untested_points() const {
    if (verdict != Verdict::judged) return 0;
    int points = most;
    for (const CaseMark& each : cases) points -= each.points;
    return points;
}

int Mark::points(bool of_trace) const {
    int sum = 0;
    bool any_is_own = false;
    for (const CaseMark& each : cases) {
        if (!each.passed || each.of_trace != of_trace) continue;
        sum += each.points;
        any_is_own = any_is_own || !each.given;
    }
    return any_is_own ? sum : 0;
}

void check_results_folder(const fs::path& results, const std::vector<fs::path>& submissions) {
    std::error_code none;
    if (fs::exists(results, none) && !fs::is_directory(results, none))
        throw InputError({results}, "is not a folder");
    for (const fs::path& each : submissions)
        if (fs::equivalent(each, results, none))
            throw InputError({results},
                             "contains the submissions: the results need a folder of their own");
    if (fs::exists(results / "seed.txt", none)) return;  // of an earlier run
    for (const char* each : report_files)
        if (fs::exists(fs::symlink_status(results / each, none)))
            throw InputError({results / each},
                             "is no result of an earlier run, and would be replaced");
}

fs::path student_folder(const fs::path& results, const std::string& student) {
    const bool is_folder = !student.empty() && student != "." && student != ".." &&
                           student.find_first_of(std::string("/\0", 2)) == std::string::npos;
    if (!is_folder) throw InputError({}, "no folder can have the name \"" + student + "\"");
    return results / students_folder / student;
}

fs::path mark_file(const fs::path& results, const std::string& student, int stage) {
    return student_folder(results, student) / (name_of(stage) + ".jsonl");
}

void write_mark(const fs::path& results, const Mark& mark) {
    std::string text = line(head(mark));
    for (const CaseMark& each : mark.cases) text += line(to_json(each));
    const fs::path file = mark_file(results, mark.student, mark.stage);
    std::error_code none;  // without a folder, writing a file fails with an error
    fs::create_directories(file.parent_path(), none);
    if (const std::optional<Mark> before = read_mark(results, mark.student, mark.stage))
        record_change(results, *before, mark);
    write_text(file, text);
}

std::optional<Mark> read_mark(const fs::path& results, const std::string& student, int stage) {
    try {
        const fs::path file = mark_file(results, student, stage);
        Mark mark = read_lines(read_text(file), file);
        if (mark.stage != stage) return std::nullopt;
        mark.student = student;  // the folder's name, which may contain any byte
        return mark;
    } catch (const InputError&) {
        return std::nullopt;
    } catch (const Json::exception&) {
        return std::nullopt;
    }
}

void remove_shared_feedback(const fs::path& results) {
    std::error_code none;
    std::vector<fs::path> shared;
    for (const fs::directory_entry& entry : fs::directory_iterator(results / students_folder, none))
        if (has_feedback_alone(entry.path())) shared.push_back(entry.path());
    for (const fs::path& each : shared) fs::remove_all(each);
}

std::vector<std::string> students_in(const fs::path& results) {
    std::vector<std::string> names;
    std::error_code none;
    for (const fs::directory_entry& entry : fs::directory_iterator(results / students_folder, none))
        if (entry.is_directory(none) && !has_feedback_alone(entry.path()))
            names.push_back(entry.path().filename().string());
    std::ranges::sort(names);
    return names;
}

std::vector<Mark> read_marks(const fs::path& results) {
    std::vector<Mark> marks;
    for (const std::string& student : students_in(results))
        for (int stage = 1; stage <= int(stage_names.size()); ++stage)
            if (std::optional<Mark> mark = read_mark(results, student, stage))
                marks.push_back(std::move(*mark));
    return marks;
}

std::vector<std::string> missing_marks(const fs::path& results, const std::vector<Mark>& marks) {
    std::set<int> stages;
    std::set<std::pair<std::string, int>> there;
    for (const Mark& mark : marks) {
        stages.insert(mark.stage);
        if (mark.verdict != Verdict::postponed) there.emplace(mark.student, mark.stage);
    }
    std::vector<std::string> missing;
    for (const std::string& student : students_in(results))
        for (const int stage : stages)
            if (there.count({student, stage}) == 0)
                missing.push_back(student + " has no mark for " + name_of(stage));
    return missing;
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

bool is_graded_at(const fs::path& results, const fs::path& place, const std::string& student) {
    const std::vector<std::string> classes = lines_in(results / classes_file);
    return classes.empty() || contains(classes, line_of(place, student));
}

void add_graded_class(const fs::path& results, const fs::path& place,
                      const std::vector<std::string>& students) {
    const std::vector<std::string> classes = lines_in(results / classes_file);
    std::string added;
    for (const std::string& each : students)
        if (const std::string line = line_of(place, each); !contains(classes, line))
            added += line + "\n";
    const fs::path file = results / classes_file;
    std::ofstream out(file, std::ios::app);
    out << added << std::flush;
    if (!out) throw InputError({file.string()}, "cannot be written");
}

}  // namespace rt::grade
