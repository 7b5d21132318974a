#include "common/course/exercise/warnings.hpp"

#include "common/course/build/compiler_errors.hpp"
#include "common/course/build/project.hpp"
#include "common/course/build/static_data.hpp"
#include "common/course/build/student_objects.hpp"
#include "common/course/exercise/may_include.hpp"

#include <cstdio>

namespace rt {

namespace {

constexpr const char* advice = "Put helper functions into an anonymous namespace: namespace { … }";

/// Warns of includes that work here, and are refused when the file is graded.
void show_refused_includes(const Workbook& workbook) {
    const int stage = workbook.stage();
    for (const std::filesystem::path& file : workbook.files())
        for (const Include& each :
             refused_includes(project_folder, {stage, file.filename() == trace_file}, file))
            std::printf(
                "%s:%d: warning: a graded file may not include %s: docs/%s.md lists the allowed "
                "headers\n",
                step_path(stage, "student/" + file.filename().string()).c_str(), each.line,
                each.header.c_str(), name_of(stage).c_str());
}

/// Warns of each source file that is linked here, but not when the stage is graded; and if there is
/// none but main.cpp, so that the reference was judged with it.
void show_ungraded_files(const Workbook& workbook) {
    const int stage = workbook.stage();
    const std::string graded = stage_header(stage).stem().string() + ".cpp";
    if (workbook.has_trace() && workbook.files().size() == 1)
        std::printf(
            "%s: warning: it is missing, so that the reference's functions were judged; graded "
            "without it, they get no points\n",
            step_path(stage, "student/" + graded).c_str());
    for (const std::filesystem::path& file : workbook.files())
        if (file.filename() != graded && file.filename() != trace_file)
            std::printf("%s: warning: only %s is graded: move what it needs of this file into it\n",
                        step_path(stage, "student/" + file.filename().string()).c_str(),
                        graded.c_str());
}

/// Prints the compiler's first warning, also if it was compiled before, with its cure.
void show_warning(int stage) {
    const std::string warning = first_warning(kept_warnings(stage));
    std::fputs(warning.c_str(), stdout);
    if (warning.find("no previous ") != std::string::npos) std::puts(advice);
}

/// Warns of symbols for which no program can be linked with another stage of the student's.
void show_shared_symbols(int stage) {
    for (const SharedSymbol& each : shared_symbols(stage))
        std::printf(
            "%s: warning: %s is defined twice, also in %s: ./course run cannot link both.\n%s\n",
            each.file.c_str(), each.name.c_str(), each.other_file.c_str(), advice);
}

/// Warns of variables that keep a value from one ray to the next.
void show_static_variables(int stage) {
    for (const StaticVariable& each : static_variables(stage))
        std::printf(each.of_each_thread
                        ? "%s:%d: warning: %s keeps its value from one ray to the next: make it a "
                          "local variable, or const\n"
                        : "%s:%d: warning: %s keeps its value from one ray to the next, and all "
                          "threads share it: make it a local variable, or const\n",
                    each.file.c_str(), each.line, each.name.c_str());
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
