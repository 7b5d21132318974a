#include "common/course/grade/grade.hpp"

#include "common/course/grade/judging/ask_suite.hpp"
#include "common/course/grade/judging/class_folder.hpp"
#include "common/course/grade/judging/judge.hpp"
#include "common/course/grade/reports/html.hpp"
#include "common/course/grade/reports/reports.hpp"
#include "common/course/grade/results/results.hpp"
#include "common/course/grade/results/term.hpp"
#include "common/course/grade/sandbox/layers.hpp"
#include "common/course/grade/sandbox/seal.hpp"
#include "common/stages/stages.hpp"
#include "common/system/escaping.hpp"
#include "common/system/input_error.hpp"
#include "common/system/parallel_for.hpp"
#include "common/system/terminal.hpp"
#include "common/system/translation.hpp"
#include "common/system/version.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdio>

namespace rt::grade {

namespace {

std::atomic<bool> stop = false;

void check_seal() {
    const std::vector<Layer> all = layers();
    for (const Layer& layer : all)
        std::fprintf(stderr, "%s %s\n", layer.holds ? "✓" : "✗", tr_text(layer.name).c_str());
    if (!hold(all))
        throw ProgramError(
            "error: submissions are not run without these. docs/reference/grading.md\n");
}

/// Prints a line that may contain names by students.
void say(const std::string& line) {
    print_error(tr_line(one_line(line)));
}

/// The folder of the results. A new one is removed if it is still empty at the end, as after an
/// error in the class.
class ResultsFolder {
public:
    explicit ResultsFolder(const fs::path& folder) : folder_(folder) {
        std::error_code error;
        is_new_ = fs::create_directories(folder, error);
        if (error) throw InputError({folder}, "cannot be made: " + error.message());
    }
    ~ResultsFolder() {
        std::error_code not_empty;
        if (is_new_) fs::remove(folder_, not_empty);
    }
    ResultsFolder(const ResultsFolder&) = delete;
    ResultsFolder& operator=(const ResultsFolder&) = delete;

private:
    fs::path folder_;
    bool is_new_ = false;
};

/// The results are one run's at a time, or one part's.
class Lock {
public:
    Lock(const fs::path& results, int part)
        : file_(results / (".lock." + std::to_string(part))),
          descriptor_(open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600)) {
        if (descriptor_ != -1 && flock(descriptor_, LOCK_EX | LOCK_NB) == 0 && is_there()) return;
        if (descriptor_ != -1) close(descriptor_);
        throw InputError({results}, "is in use by another run, or not writable");
    }
    ~Lock() {
        unlink(file_.c_str());
        close(descriptor_);
    }
    Lock(const Lock&) = delete;
    Lock& operator=(const Lock&) = delete;

private:
    /// Still: a run that ended just now has removed its own.
    [[nodiscard]] bool is_there() const {
        struct stat mine {};
        struct stat there {};
        return fstat(descriptor_, &mine) == 0 && stat(file_.c_str(), &there) == 0 &&
               mine.st_ino == there.st_ino;
    }

    fs::path file_;
    int descriptor_;
};

/// The start of the workshop's name. The results' place is in it, so that the next run removes the
/// folder of a killed run.
std::string workshop_start(const Order& order) {
    const std::size_t whose = fs::hash_value(fs::absolute(order.results).lexically_normal());
    return "raysteps-grading-" + std::to_string(whose) + "-" + std::to_string(order.part) + ".";
}

void remove_old_workshops(const fs::path& place, const std::string& start) {
    std::error_code none;
    for (const auto& each : fs::directory_iterator(place, none))
        if (each.path().filename().string().starts_with(start)) fs::remove_all(each.path(), none);
}

/// The lecturer's folder is accessible to root's builders, too, who are unprivileged users.
void let_builders_enter(const fs::path& folder) {
    if (geteuid() == 0 && (lchown(folder.c_str(), 0, builders_group) != 0 ||
                           chmod(folder.c_str(), S_IRWXU | S_IXGRP) != 0))
        throw InputError({folder}, "cannot be made accessible to compilers");
}

std::set<int> stages_of(const Order& order) {
    std::set<int> stages;
    for (int stage = 1; stage <= int(stage_names.size()); ++stage)
        if (fs::exists(order.build / "seats" / (name_of(stage) + ".o")) &&
            (order.stages.empty() || order.stages.count(stage) == 1))
            stages.insert(stage);
    if (stages.empty()) throw InputError({}, "no stage among these is built");
    return stages;
}

/// The folder of the class's language; nothing for English. Throws InputError if there is none.
fs::path language_folder(const Term& term, const fs::path& project) {
    if (term.language.empty() || term.language == "en") return {};
    const fs::path folder = project / "lang" / term.language;
    if (!fs::exists(folder / "grading.po"))
        throw InputError(term.language_place,
                         "\"" + term.language +
                             "\" is no language: expected en, or a folder of lang/ that has "
                             "grading.po");
    return folder;
}

void read_catalogues(const fs::path& folder) {
    for (const char* const catalogue : {"grading.po", "course.po", "program.po"})
        read_translations(folder / catalogue);
}

/// Reads the translations into the class's language, in place of those for the terminal.
void read_language(const Term& term, const fs::path& project) {
    forget_translations();
    const fs::path folder = language_folder(term, project);
    if (folder.empty()) return;
    read_catalogues(folder);
    for (const std::string_view stage : stage_names)
        read_translations(folder / "steps" / stage / "sentences.po");
}

/// Before anything is written.
void check_places(const Order& order) {
    for (const fs::path& place : order.places)
        if (!fs::exists(place)) throw InputError({place}, "does not exist");
    check_results_folder(order.results, order.places);
}

/// Those of this part, of the students that were named.
std::vector<Submission> chosen(const std::vector<Submission>& all, const Order& order) {
    std::set<std::string> submitted;
    for (const Submission& each : all) submitted.insert(each.student);
    // An error in the roster ends the run before it grades anybody.
    const Term term = read_term(order.results, read_marks(order.results), submitted);
    std::set<std::string> named;
    for (const std::string& name : order.students) {
        const std::optional<std::string> student = term.names.find(name, {});
        if (!student || submitted.count(*student) == 0)
            throw InputError({}, "no student \"" + name + "\"" +
                                     (student ? ": " + *student + " has submitted nothing" : ""));
        named.insert(*student);
    }
    std::vector<Submission> mine;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (int(i) % order.parts == order.part - 1 &&
            (named.empty() || named.count(all[i].student) == 1))
            mine.push_back(all[i]);
    return mine;
}

/// Throws InputError if the folder of a class would replace marks of a class in another folder: it
/// may be one student's submission, who has named files as others'.
void check_replaced(const ClassFolder& found, const Order& order) {
    if (!order.students.empty() || order.is_class) return;
    const std::vector<std::string> graded = students_in(order.results);
    for (const auto& [place, students] : found.classes) {
        std::string replaced;
        for (const std::string& student : students)
            if (std::ranges::binary_search(graded, student) &&
                !is_graded_at(order.results, place, student))
                replaced += (replaced.empty() ? "" : ", ") + student;
        if (!replaced.empty())
            throw InputError({place},
                             "looks like a class, and would replace the marks of " + replaced +
                                 ", which are from another folder: --student NAME for a new "
                                 "submission, --class if it is the class, --one if it is one "
                                 "submission");
    }
}

/// Stores the places of the class and their students, whose marks later runs on them may replace.
void add_graded_classes(const ClassFolder& found, const std::vector<Submission>& mine,
                        const Order& order) {
    for (auto [place, students] : found.classes) {
        if (!order.students.empty())
            std::erase_if(students, [&mine](const std::string& student) {
                return std::ranges::find(mine, student, &Submission::student) == mine.end();
            });
        add_graded_class(order.results, place, students);
    }
}

/// The files that belong to no submission, and the students of an earlier run who are not in the
/// class any more: nothing removes their marks but the lecturer.
std::vector<std::string> all_left_over(const ClassFolder& found, const fs::path& results) {
    std::set<std::string> there;
    for (const Submission& each : found.submissions) there.insert(each.student);
    std::vector<std::string> all = found.left_over;
    for (const std::string& student : students_in(results))
        if (there.count(student) == 0)
            all.push_back(student +
                          ": not in the class any more; the marks of an earlier run stay "
                          "until you remove students/" +
                          student);
    return all;
}

/// Prints what is left over, and stores it for the class report.
void report_left_over(const fs::path& results, const std::vector<std::string>& left_over) {
    std::string text;
    for (const std::string& each : left_over) {
        say(each);
        text += one_line(each) + "\n";
    }
    write_text(results / left_over_file, text);
}

/// Prints the marks that a run has changed.
void report_changes(const fs::path& results, std::uintmax_t size_before) {
    const std::vector<std::string> lines = changes_since(results, size_before);
    if (!lines.empty())
        say(counted(int(lines.size()), "mark") + " changed, in " +
            (results / changes_file).string() + ":");
    for (const std::string& each : lines) say("  " + each);
}

/// Compiles each reference alone: a compiler that cannot read its headers fails for all
/// submissions.
void compile_references(const Order& order, const Grading& grading) {
    const std::vector<int> stages(grading.stages.begin(), grading.stages.end());
    parallel_for(order.jobs, stages.size(), &stop,
                 [&](std::size_t i) { compile_reference(grading, stages[i]); });
}

std::map<int, ReferenceResult> judge_references(const Order& order, const Grading& grading) {
    const std::vector<int> stages(grading.stages.begin(), grading.stages.end());
    std::vector<ReferenceResult> found(stages.size());
    parallel_for(order.jobs, stages.size(), &stop, [&](std::size_t i) {
        found[i] = judge_reference(grading, stages[i], grading.workshop.folder);
    });
    std::map<int, ReferenceResult> reference_results;
    for (std::size_t i = 0; i < stages.size(); ++i)
        if (!found[i].cases.empty()) reference_results[stages[i]] = found[i];
    return reference_results;
}

Outcome grade(const Order& order, const fs::path& folder) {
    Grading grading{.project = order.project,
                    .build = order.build,
                    .results = fs::absolute(order.results),
                    .workshop = open_workshop(order.project, order.build, folder),
                    .stages = stages_of(order)};
    grading.workshop.stop = &stop;
    const ClassFolder found =
        order.one ? one_submission(order.places)
                  : find_class(grading.workshop, order.places, order.results, order.is_class);
    for (const std::string& each : found.taken_as) say(each);
    check_replaced(found, order);
    const std::vector<Submission> submissions = chosen(found.submissions, order);
    grading.seed = seed_identifier(agreed_seed(order.results, order.seed_file));
    add_graded_classes(found, submissions, order);
    // Grading one student again keeps the report on the class.
    const bool is_class = found.submissions.size() > 1 || !found.left_over.empty();
    if (is_class && order.part == 1 && order.students.empty())
        report_left_over(order.results, all_left_over(found, order.results));
    compile_references(order, grading);
    Judge judge(grading, judge_references(order, grading));
    go_on(grading.workshop);
    say(counted(int(submissions.size()), "submission") + ", " +
        counted(int(grading.stages.size()), "stage") + ", seed " + grading.seed);
    Progress progress(true, int(submissions.size()));
    std::atomic<bool> failed = false;
    parallel_for(order.jobs, submissions.size(), &stop, [&](std::size_t i) {
        const std::string why = judge.judge(submissions[i]);
        if (!why.empty()) {
            failed = true;
            say("error: " + submissions[i].student + " could not be graded: " + why);
        }
        progress.advance();
    });
    go_on(grading.workshop);
    return failed ? Outcome::failed : Outcome::judged;
}

std::string edition_of(const fs::path& results, const fs::path& project) {
    const std::string edition = today() + ", Raysteps " + version(project);
    if (!fs::exists(seed_file(results))) return edition;
    return tr("{edition}, seed {seed}",
              {{"edition", edition}, {"seed", seed_identifier(read_seed(seed_file(results)))}});
}

}  // namespace

Outcome grade(const Order& order) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP})
        std::signal(signal, [](int) { stop = true; });
    std::signal(SIGCHLD, SIG_DFL);  // a caller that ignores it would hide how processes end
    check_seal();
    check_places(order);
    // An error there ends the run at its start.
    static_cast<void>(language_folder(read_term(order.results, {}), order.project));
    const ResultsFolder results(order.results);
    const Lock lock(order.results, order.part);
    const fs::path place = fs::absolute(temporary_place());  // tools start in folders of their own
    check_executable(place);
    remove_old_workshops(place, workshop_start(order));
    const TemporaryFolder workplace(place, workshop_start(order));
    let_builders_enter(workplace.path());
    const std::uintmax_t size_before = size_of_changes(order.results);
    Outcome outcome = Outcome::interrupted;
    try {
        outcome = grade(order, workplace.path());
    } catch (const Interrupted&) {
        // as it says
    }
    report_changes(order.results, size_before);
    return outcome;
}

void read_terminal_language(const fs::path& project) {
    forget_translations();
    if (const std::string language = language_of_environment(); !language.empty())
        read_catalogues(project / "lang" / language);
}

void write_reports(const fs::path& results, const fs::path& project, const fs::path& gradescope) {
    const std::vector<Mark> marks = read_marks(results);
    if (marks.empty()) throw InputError({results}, "contains no marks");
    Term term = read_term(results, marks);
    if (term.anonymous) term.key = read_seed(seed_file(results));
    for (const std::string& each : term.notes) say(each);
    const std::vector<std::string> missing = missing_marks(results, marks);
    for (const std::string& each : missing) say(each);
    if (!missing.empty()) say("the reports are incomplete: `./course grade` adds what is missing");
    read_language(term, project);
    write_grade_book(results, marks, term);
    const std::string grades = write_upload(results, marks, term);
    write_feedback(results, marks, term);
    write_class_report(results, project, marks, term, edition_of(results, project));
    write_junit(results, marks);
    if (!gradescope.empty()) write_gradescope(gradescope, marks);
    read_terminal_language(project);
    if (!grades.empty()) say(grades);
}

}  // namespace rt::grade
