#include "common/course/exercise/warnings.hpp"

#include "common/course/build/compiler_errors.hpp"
#include "common/course/build/project.hpp"
#include "common/course/build/static_data.hpp"
#include "common/course/build/student_objects.hpp"
#include "common/course/exercise/may_include.hpp"
#include "common/system/files.hpp"
#include "common/system/translation.hpp"
#include "common/system/wrap.hpp"

namespace rt {

namespace {

constexpr const char* advice =
    to_translate("Put helper functions into an anonymous namespace: namespace { … }");

/// "steps/…/student/sphere.cpp:2: warning: …"
std::string warning(const std::string& place, const std::string& words) {
    return wrapped(tr("{place}: warning: {words}", {{"place", place}, {"words", words}})) + "\n";
}

/// Warns of includes that work here, and are refused when the file is graded.
std::string refused_includes_of(const Workbook& workbook) {
    const int stage = workbook.stage();
    std::string text;
    for (const fs::path& file : workbook.files())
        for (const Include& each :
             refused_includes(project_folder, {stage, file.filename() == trace_file}, file))
            text += warning(
                step_path(stage, "student/" + file.filename().string()) + ":" +
                    std::to_string(each.line),
                tr("a graded file may not include {header}: docs/{stage}.md lists the allowed "
                   "headers",
                   {{"header", each.header}, {"stage", name_of(stage)}}));
    return text;
}

/// Warns of each source file that is linked here, but not when the stage is graded; and if there is
/// none but main.cpp, so that the reference was judged with it.
std::string ungraded_files_of(const Workbook& workbook) {
    const int stage = workbook.stage();
    std::string text;
    const std::string graded = stage_header(stage).stem().string() + ".cpp";
    if (workbook.has_trace() && workbook.files().size() == 1)
        text += warning(
            step_path(stage, "student/" + graded),
            tr("it is missing, so that the reference's functions were judged; graded without it, "
               "they get no points"));
    for (const fs::path& file : workbook.files())
        if (file.filename() != graded && file.filename() != trace_file)
            text += warning(step_path(stage, "student/" + file.filename().string()),
                            tr("only {file} is graded: move what it needs of this file into it",
                               {{"file", graded}}));
    return text;
}

std::string cure() {
    return wrapped_prose(tr(advice)) + "\n";
}

/// The compiler's first warning, also if it was compiled before, with its cure.
std::string compiler_warning(int stage) {
    const std::string first = first_warning(kept_warnings(stage));
    return wrapped_diagnostic(first) +
           (first.find("no previous ") != std::string::npos ? cure() : "");
}

/// Warns of symbols for which no program can be linked with another stage of the student's.
std::string shared_symbols_of(int stage, const std::vector<CompiledFile>& files) {
    std::string text;
    for (const SharedSymbol& each : shared_symbols(stage, files))
        text +=
            warning(each.file.string(),
                    tr("{symbol} is defined twice, also in {file}: ./course run cannot link both.",
                       {{"symbol", each.name}, {"file", each.other_file.string()}})) +
            cure();
    return text;
}

/// Warns of variables that keep a value from one ray to the next.
std::string static_variables_of(int stage, const std::vector<CompiledFile>& files) {
    std::string text;
    for (const StaticVariable& each : static_variables(stage, files))
        text += warning(
            each.file.string() + ":" + std::to_string(each.line),
            each.of_each_thread
                ? tr("{name} keeps its value from one ray to the next: make it a local variable, "
                     "or const",
                     {{"name", each.name}})
                : tr("{name} keeps its value from one ray to the next, and all threads share it: "
                     "make it a local variable, or const",
                     {{"name", each.name}}));
    return text;
}

}  // namespace

std::string warnings_of(const Workbook& workbook) {
    const int stage = workbook.stage();
    const std::vector<CompiledFile> files = compiled_files();
    return compiler_warning(stage) + static_variables_of(stage, files) +
           shared_symbols_of(stage, files) + refused_includes_of(workbook) +
           ungraded_files_of(workbook);
}

}  // namespace rt
