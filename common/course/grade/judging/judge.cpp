#include "common/course/grade/judging/judge.hpp"

#include "common/course/exercise/trace_mistakes.hpp"
#include "common/course/grade/judging/submission_job.hpp"
#include "common/course/grade/results/sha256.hpp"
#include "common/stages/reasons.hpp"
#include "common/stages/stages.hpp"

#include <algorithm>
#include <cstdio>

namespace rt::grade {

namespace {

bool was_waited_for(const CaseMark& each) {
    return !each.passed && (each.words.find("gave no answer within") != std::string::npos ||
                            each.words.find("took longer than") != std::string::npos);
}

/// The passing cases are known. A case that also fails with the suite's own inputs is reported as
/// by `./course check`, with inputs that a student can repeat. Returns the cases with these inputs.
std::vector<CaseMark> retell(std::vector<CaseMark>& cases, const Grading& grading,
                             GradedFile graded, const fs::path& worker) {
    if (std::ranges::all_of(cases, &CaseMark::passed)) return cases;
    if (std::ranges::any_of(cases, was_waited_for)) return cases;  // it would be again
    std::vector<CaseMark> as_written =
        ask_suite(grading, graded, worker, {"RAYSTEPS_AS_WRITTEN=1"});
    for (const CaseMark& marked : as_written)
        for (CaseMark& each : cases)
            if (!each.passed && !marked.passed && each.name == marked.name) {
                each.place = marked.place;
                each.words = marked.words;
            }
    return as_written;
}

/// The cases as a report of the suite, which diagnose reads.
void write_report(const fs::path& file, const std::vector<CaseMark>& cases) {
    std::string text;
    for (const CaseMark& each : cases)
        text += "case " + each.name + "\n" + (each.passed ? "passed" : "failed") + "\n";
    write_text(file, text);
}

/// The cases of one of a stage's files.
std::vector<CaseMark> cases_of(const std::vector<CaseMark>& all, GradedFile graded) {
    std::vector<CaseMark> some;
    for (const CaseMark& each : all)
        if (each.of_trace == graded.is_trace) some.push_back(each);
    return some;
}

int points_of(const std::vector<CaseMark>& cases) {
    int points = 0;
    for (const CaseMark& each : cases) points += each.points;
    return points;
}

/// The same marks as if the suite had reached all cases.
std::vector<CaseMark> completed(std::vector<CaseMark> cases, const std::vector<CaseMark>& all) {
    for (std::size_t i = cases.size(); i < all.size(); ++i)
        cases.push_back({.name = all[i].name,
                         .points = all[i].points,
                         .given = all[i].given,
                         .of_trace = all[i].of_trace,
                         .words = std::string(not_reached) + "\n"});
    return cases;
}

/// True if the suite ended by the limit of all its cases. A worker without an answer for that long
/// gets no more queries.
bool is_out_of_time(const Mark& mark) {
    return std::ranges::any_of(mark.cases, [](const CaseMark& each) {
        return each.words.find(not_reached) != std::string::npos ||
               each.words.find(too_long_a_suite) != std::string::npos;
    });
}

/// True if every function is written: the result of a stub may look like a known mistake.
bool is_written(const std::string& text) {
    return std::ranges::none_of(lines_of(text), [](const std::string& line) {
        return trimmed(line).starts_with("RT_TODO");
    });
}

/// Parses the output of the program `diagnose`, by the first word of each line.
void read_diagnosis(const std::string& output, Mark& mark) {
    std::string* part = nullptr;
    for (const std::string& line : lines_of(output)) {
        if (const auto mistake = after("mistake: ", line)) {
            mark.mistake +=
                (mark.mistake.empty() ? "" : "\n") + mistake->substr(mistake->find(": ") + 2);
            part = nullptr;
        } else {
            const auto always = after("always: ", line);
            if (always || line.starts_with("smallest: ")) part = &mark.smallest;
            if (part != nullptr) *part += always.value_or(line) + "\n";
        }
    }
}

/// The cases are those with the suite's own inputs.
void name_trace_mistakes(const Grading& grading, const std::vector<CaseMark>& cases, Mark& mark) {
    std::vector<CaseResult> results;
    for (const CaseMark& each : cases)
        results.push_back({.name = each.name, .passed = each.passed, .failures = each.failures});
    for (const TraceMistake& each : recognized_trace_mistakes(
             grading.project / "tests/mistakes" / stage_name(mark.stage) / "trace.txt", results))
        mark.mistake += (mark.mistake.empty() ? "" : "\n") + each.sentence;
}

/// The part of the picture that the student's own stages draw.
std::optional<PictureMark> picture_of(const Grading& grading, int stage, const fs::path& worker,
                                      const fs::path& file) {
    // In the workshop first: a worker without an answer and a full disk are different failures.
    const fs::path drawn = worker.parent_path() / file.filename();
    const ProcessResult ending = run_asking(
        grading, stage, {"ask_picture", worker.string(), name_of(stage), drawn.string()}, {});
    PictureMark mark{.file = file.filename()};
    if (std::sscanf(ending.output.c_str(), "%d %d", &mark.pixels, &mark.different) != 2) {
        check_space(drawn.parent_path());
        return {};
    }
    copy_whole(drawn, file);
    fs::remove(drawn);
    return mark;
}

}  // namespace

void compile_reference(const Grading& grading, int stage) {
    const std::vector<fs::path> files =
        files_in(grading.project / "steps" / stage_name(stage) / "reference", ".cpp");
    const TemporaryFolder scratch(grading.workshop.folder);
    const Build made = compile_submission(grading.workshop, stage, read_text(files.at(0)),
                                          scratch.path() / "reference.o");
    if (!made.succeeded)
        throw ProgramError("error: even the reference of " + name_of(stage) +
                           " does not compile in the sandbox. Is the compiler, or GLM, "
                           "in a folder that other users cannot read?\n" +
                           made.words + "\n");
}

ReferenceResult judge_reference(const Grading& grading, int stage, const fs::path& folder) {
    ReferenceResult reference_result{.worker = folder / (name_of(stage) + "_reference")};
    const Build made = link_worker(grading.workshop, stage, {}, reference_result.worker);
    if (!made.succeeded) throw ProgramError(made.words);
    std::string suites;
    for (const GradedFile graded : files_of(stage)) {
        for (CaseMark& each : ask_suite(grading, graded, reference_result.worker))
            reference_result.cases.push_back(std::move(each));
        suites += read_text(grading.build / (name_of(graded) + "_asked_test_double"));
    }
    for (const CaseMark& each : reference_result.cases)
        if (!each.passed)
            throw ProgramError("error: the reference of " + name_of(stage) +
                               " itself fails: " + each.name + "\n" + each.words);
    reference_result.key = sha256_of_all(grading.seed, suites, read_text(reference_result.worker));
    return reference_result;
}

Mark Judge::mark(SubmissionJob& job, int stage) {
    const ReferenceResult& reference_result = yardsticks_.at(stage);
    Mark mark{.student = job.student(), .stage = stage, .most = points_of(reference_result.cases)};
    std::string known = name_of(stage);
    bool any = false;
    for (const GradedFile each : files_of(stage)) {
        mark.words += job.words(each);
        known += job.source(each) + "-";
        any = any || job.has(each);
    }
    if (!any) return mark;
    mark.source = job.source(stage);
    mark.trace_source = job.source({stage, true});
    known += mark.words;
    {
        const std::lock_guard lock(mutex_);
        const auto found = known_.find(known);
        if (found != known_.end()) {
            const Mark& same = found->second;
            if (!same.slice.empty())
                copy_whole(student_folder(grading_.results, same.student) / same.slice,
                           job.beside(stage, ".svg"));
            return same;
        }
    }
    mark.verdict = Verdict::refused;
    for (const GradedFile each : files_of(stage)) {
        if (job.has(each))
            mark_file(job, each, mark);
        else
            mark.words += file_name(each) + " was not submitted: its " +
                          std::to_string(points_of(cases_of(reference_result.cases, each))) +
                          " points are not given.\n";
    }
    const std::lock_guard lock(mutex_);
    known_[known] = mark;
    return mark;
}

void Judge::mark_file(SubmissionJob& job, GradedFile graded, Mark& mark) {
    const int stage = graded.stage;
    const ReferenceResult& reference_result = yardsticks_.at(stage);
    Build made = job.compiled(graded);
    if (made.succeeded) made = job.link(graded);
    if (!made.succeeded) {
        if (has_trace(stage)) mark.words += file_name(graded) + " cannot be graded:\n";
        mark.words += made.words + (made.words.ends_with('\n') ? "" : "\n");
        return;
    }
    mark.verdict = Verdict::judged;
    std::vector<CaseMark> cases = ask_suite(grading_, graded, job.worker());
    const std::vector<CaseMark> as_written = retell(cases, grading_, graded, job.worker());
    cases = completed(cases, cases_of(reference_result.cases, graded));
    mark.cases.insert(mark.cases.end(), cases.begin(), cases.end());
    if (std::ranges::all_of(cases, &CaseMark::passed)) return;
    if (graded.is_trace) {
        const bool is_whole = as_written.size() == cases.size() && !is_out_of_time(mark);
        if (is_whole && is_written(job.text(graded)))
            name_trace_mistakes(grading_, as_written, mark);
        return;
    }
    if (!is_written(job.text(graded))) {
        mark.words +=
            "Your file still contains RT_TODO: it was not compared with known mistakes.\n";
    } else if (is_out_of_time(mark)) {
        mark.words += "Your file took too long: it was not compared with known mistakes.\n";
    } else {
        const std::string probes =
            grading_.project / "tests/mistakes" / stage_name(stage) / "probes.txt";
        const fs::path report = job.worker().parent_path() / (name_of(stage) + ".report");
        const fs::path slice = job.worker().parent_path() / (name_of(stage) + ".svg");
        write_report(report, as_written);
        const ProcessResult ending =
            run_asking(grading_, stage,
                       {"diagnose", probes, job.worker().string(), reference_result.worker.string(),
                        report.string(), slice.string()},
                       {});
        fs::remove(report);
        if (!ending.out_of_time && ending.status == 1) read_diagnosis(ending.output, mark);
        if (ending.status > 1) check_space(slice.parent_path());
        if (fs::exists(slice)) {
            copy_whole(slice, job.beside(stage, ".svg"));
            fs::remove(slice);
            mark.slice = name_of(stage) + ".svg";
        }
    }
}

std::optional<PictureMark> Judge::picture(SubmissionJob& job, int stage) {
    const std::string known = name_of(stage) + job.chain(stage);
    {
        const std::lock_guard lock(mutex_);
        const auto found = drawn_.find(known);
        if (found != drawn_.end()) {
            const auto& [student, mark] = found->second;
            copy_whole(student_folder(grading_.results, student) / mark.file,
                       job.beside(stage, ".png"));
            return mark;
        }
    }
    if (!job.link_chain(stage).succeeded) return {};
    const std::optional<PictureMark> mark =
        picture_of(grading_, stage, job.worker(), job.beside(stage, ".png"));
    const std::lock_guard lock(mutex_);
    if (mark) drawn_[known] = {job.student(), *mark};
    return mark;
}

void Judge::judge(SubmissionJob& job, int stage) {
    go_on(grading_.workshop);
    const ReferenceResult& reference_result = yardsticks_.at(stage);
    const std::string key = job.key(stage, reference_result.key);
    const std::optional<Mark> before = read_mark(grading_.results, job.student(), stage);
    if (before && before->key == key) return;
    for (const char* ending : {".svg", ".png"}) fs::remove(job.beside(stage, ending));
    Mark came = mark(job, stage);
    came.student = job.student();
    came.key = key;
    if (came.verdict == Verdict::judged && !is_out_of_time(came))
        came.picture = picture(job, stage);
    write_mark(grading_.results, came);
}

void Judge::postpone(const std::string& student, int stage) {
    Mark mark{.student = student,
              .stage = stage,
              .verdict = Verdict::postponed,
              .words =
                  "Your file could not be graded, through no fault of yours. It will be "
                  "judged again.\n",
              .most = points_of(yardsticks_.at(stage).cases)};
    try {
        write_mark(grading_.results, mark);
    } catch (const std::exception&) {
        // the report already gives the reason why this student is missing in the grade book
    }
}

std::string Judge::judge(const Submission& submission) {
    std::string why;
    auto next = yardsticks_.begin();
    const auto failed = [&](const std::exception& error) {
        if (why.empty()) why = error.what();
        if (why.ends_with('\n')) why.pop_back();  // of a program's words
        postpone(submission.student, next->first);
    };
    try {
        SubmissionJob job(grading_, submission);
        for (; next != yardsticks_.end(); ++next) {
            try {
                judge(job, next->first);
            } catch (const Interrupted&) {
                throw;
            } catch (const std::exception& error) {
                failed(error);
            }
        }
    } catch (const Interrupted&) {
        throw;
    } catch (const std::exception& error) {
        for (; next != yardsticks_.end(); ++next) failed(error);
    }
    return why;
}

}  // namespace rt::grade
