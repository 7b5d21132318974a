#include "common/course/grade/judging/submission_job.hpp"

#include "common/course/grade/results/sha256.hpp"
#include "common/course/grade/results/winnowing.hpp"
#include "common/stages/stages.hpp"

namespace rt::grade {

namespace {

/// The files that draw the picture of a stage.
std::vector<GradedFile> chain_of(int stage) {
    std::vector<GradedFile> files;
    for (int each = 1; each <= stage; ++each) files.emplace_back(each);
    files.emplace_back(stage, true);
    return files;
}

}  // namespace

SubmissionJob::SubmissionJob(const Grading& grading, const Submission& submission)
    : grading_(grading),
      student_(submission.student),
      handed_in_(take_in(grading.workshop, submission)),
      scratch_(grading.workshop.folder) {
    leave_out_ours();
    // The workers in this folder are run by unprivileged users.
    fs::permissions(scratch_.path(), fs::perms(0755));
    fs::create_directories(student_folder(grading_.results, student_) / "submitted");
    for (const auto& [file, text] : handed_in_.files)
        write_text(student_folder(grading_.results, student_) / "submitted" / submitted_name(file),
                   text);
}

void SubmissionJob::leave_out_ours() {
    for (auto each = handed_in_.files.begin(); each != handed_in_.files.end();) {
        const std::string why = each->first.is_trace ? why_ours(each->first, each->second) : "";
        if (!why.empty()) handed_in_.words[each->first] += why + "\n";
        each = why.empty() ? std::next(each) : handed_in_.files.erase(each);
    }
}

std::string SubmissionJob::why_ours(GradedFile file, const std::string& text) const {
    const fs::path stage = grading_.project / "steps" / stage_name(file.stage);
    const std::string projects = read_text(stage / "main.cpp");
    if (text == projects) return "main.cpp is the project's own file.";
    const std::string starter = read_text(stage / "starter/main.cpp");
    return is_copy_of_main(text, projects, starter) ? copied_main : "";
}

std::string SubmissionJob::source(GradedFile file) const {
    return has(file) ? sha256(text(file)) : "";
}

std::string SubmissionJob::words(GradedFile file) const {
    const auto found = handed_in_.words.find(file);
    if (found != handed_in_.words.end()) return found->second;
    return file.is_trace ? "" : handed_in_.words_on_all;
}

std::string SubmissionJob::chain(int stage) const {
    std::string all;
    for (const GradedFile each : chain_of(stage)) all += source(each) + "-";
    return sha256(all);
}

std::string SubmissionJob::key(int stage, const std::string& reference) const {
    return sha256_of_all(reference, words(stage) + words({stage, true}), chain(stage));
}

const Build& SubmissionJob::compiled(GradedFile file) {
    const auto known = compiled_.find(file);
    if (known != compiled_.end()) return known->second;
    return compiled_[file] = compile_submission(grading_.workshop, file, text(file), object(file));
}

Build SubmissionJob::link(GradedFile file) {
    return link(file.stage, {{file, object(file)}});
}

Build SubmissionJob::link_chain(int stage) {
    std::map<GradedFile, fs::path> objects;
    for (const GradedFile each : chain_of(stage))
        if (has(each) && compiled(each).succeeded) objects[each] = object(each);
    return link(stage, objects);
}

fs::path SubmissionJob::beside(int stage, const std::string& ending) const {
    return student_folder(grading_.results, student_) / (name_of(stage) + ending);
}

fs::path SubmissionJob::object(GradedFile file) const {
    return scratch_.path() / (name_of(file) + ".o");
}

Build SubmissionJob::link(int stage, const std::map<GradedFile, fs::path>& objects) {
    if (linked_ == std::pair(stage, objects)) return {.succeeded = true};  // it is there
    linked_ = {};
    Build made = link_worker(grading_.workshop, stage, objects, worker());
    if (made.succeeded) linked_ = {stage, objects};
    return made;
}

}  // namespace rt::grade
