#include "common/course/exercise/warnings.hpp"

#include "common/course/build/compiler_errors.hpp"
#include "common/course/build/project.hpp"
#include "common/course/build/static_data.hpp"
#include "common/course/build/student_objects.hpp"
#include "common/course/exercise/may_include.hpp"
#include "common/system/translation.hpp"
#include "common/system/wrap.hpp"

#include <cstdio>

namespace rt {

namespace {

constexpr const char* advice =
    to_translate("Put helper functions into an anonymous namespace: namespace { … }");

/// Prints "steps/…/student/sphere.cpp:2: warning: …".
void warn(const std::string& place, const std::string& words) {
    const std::string line = tr("{place}: warning: {words}", {{"place", place}, {"words", words}});
    std::printf("%s\n", wrapped(line).c_str());
}

/// Warns of includes that work here, and are refused when the file is graded.
void show_refused_includes(const Workbook& workbook) {
    const int stage = workbook.stage();
    for (const std::filesystem::path& file : workbook.files())
        for (const Include& each :
             refused_includes(project_folder, {stage, file.filename() == trace_file}, file))
            warn(step_path(stage, "student/" + file.filename().string()) + ":" +
                     std::to_string(each.line),
                 tr("a graded file may not include {header}: docs/{stage}.md lists the allowed "
                    "headers",
                    {{"header", each.header}, {"stage", name_of(stage)}}));
}

/// Warns of each source file that is linked here, but not when the stage is graded; and if there is
/// none but main.cpp, so that the reference was judged with it.
void show_ungraded_files(const Workbook& workbook) {
    const int stage = workbook.stage();
    const std::string graded = stage_header(stage).stem().string() + ".cpp";
    if (workbook.has_trace() && workbook.files().size() == 1)
        warn(step_path(stage, "student/" + graded),
             tr("it is missing, so that the reference's functions were judged; graded without it, "
                "they get no points"));
    for (const std::filesystem::path& file : workbook.files())
        if (file.filename() != graded && file.filename() != trace_file)
            warn(step_path(stage, "student/" + file.filename().string()),
                 tr("only {file} is graded: move what it needs of this file into it",
                    {{"file", graded}}));
}

/// Prints the compiler's first warning, also if it was compiled before, with its cure.
void show_warning(int stage) {
    const std::string warning = first_warning(kept_warnings(stage));
    std::fputs(wrapped_diagnostic(warning).c_str(), stdout);
    if (warning.find("no previous ") != std::string::npos)
        std::puts(wrapped_prose(tr(advice)).c_str());
}

/// Warns of symbols for which no program can be linked with another stage of the student's.
void show_shared_symbols(int stage) {
    for (const SharedSymbol& each : shared_symbols(stage)) {
        warn(each.file.string(),
             tr("{symbol} is defined twice, also in {file}: ./course run cannot link both.",
                {{"symbol", each.name}, {"file", each.other_file.string()}}));
        std::puts(wrapped_prose(tr(advice)).c_str());
    }
}

/// Warns of variables that keep a value from one ray to the next.
void show_static_variables(int stage) {
    for (const StaticVariable& each : static_variables(stage))
        warn(each.file.string() + ":" + std::to_string(each.line),
             each.of_each_thread
                 ? tr("{name} keeps its value from one ray to the next: make it a local variable, "
                      "or const",
                      {{"name", each.name}})
                 : tr("{name} keeps its value from one ray to the next, and all threads share it: "
                      "make it a local variable, or const",
                      {{"name", each.name}}));
}

}  // namespace

void show_warnings(const Workbook& workbook) {
    show_warning(workbook.stage());
    show_static_variables(workbook.stage());
    show_shared_symbols(workbook.stage());
    show_refused_includes(workbook);
    show_ungraded_files(workbook);
}

}  // namespace rt
