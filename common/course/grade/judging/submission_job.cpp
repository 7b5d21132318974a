#include "common/course/grade/judging/submission_job.hpp"

#include "common/course/grade/judging/sha256.hpp"
#include "common/stages/stages.hpp"

namespace rt::grade {

namespace {

namespace fs = std::filesystem;

}  // namespace

SubmissionJob::SubmissionJob(const Grading& grading, const Submission& submission)
    : grading_(grading),
      student_(submission.student),
      handed_in_(take_in(grading.workshop, submission)),
      scratch_(grading.workshop.folder) {
    // The workers in this folder are run by unprivileged users.
    fs::permissions(scratch_.path(), fs::perms(0755));
    fs::create_directories(student_folder(grading_.results, student_) / "submitted");
    for (const auto& [stage, text] : handed_in_.files)
        write_text(student_folder(grading_.results, student_) / "submitted" /
                       (name_of(stage).substr(7) + ".cpp"),
                   text);
}

std::string SubmissionJob::words(int stage) const {
    const auto found = handed_in_.words.find(stage);
    return found == handed_in_.words.end() ? handed_in_.words_on_all : found->second;
}

std::string SubmissionJob::chain(int stage) const {
    std::string all;
    for (int each = 1; each <= stage; ++each) all += has(each) ? sha256(text(each)) : "-";
    return sha256(all);
}

std::string SubmissionJob::key(int stage, const std::string& reference) const {
    return sha256_of_all(reference, words(stage), chain(stage));
}

const Build& SubmissionJob::compiled(int stage) {
    const auto known = compiled_.find(stage);
    if (known != compiled_.end()) return known->second;
    return compiled_[stage] =
               compile_submission(grading_.workshop, stage, text(stage), object(stage));
}

Build SubmissionJob::link(int stage) {
    return link(stage, {{stage, object(stage)}});
}

Build SubmissionJob::link_chain(int stage, std::chrono::steady_clock::time_point until) {
    std::map<int, fs::path> objects;
    for (int each = 1; each <= stage; ++each) {
        if (std::chrono::steady_clock::now() > until) return {};
        if (has(each) && compiled(each).succeeded) objects[each] = object(each);
    }
    return link(stage, objects);
}

fs::path SubmissionJob::beside(int stage, const std::string& ending) const {
    return student_folder(grading_.results, student_) / (name_of(stage) + ending);
}

fs::path SubmissionJob::object(int stage) const {
    return scratch_.path() / (name_of(stage) + ".o");
}

Build SubmissionJob::link(int stage, const std::map<int, fs::path>& objects) {
    if (linked_ == std::pair(stage, objects)) return {.succeeded = true};  // it is there
    linked_ = {};
    Build made = link_worker(grading_.workshop, stage, objects, worker());
    if (made.succeeded) linked_ = {stage, objects};
    return made;
}

}  // namespace rt::grade
