#include "common/course/exercise/commands.hpp"

#include "common/course/build/build.hpp"
#include "common/course/build/project.hpp"
#include "common/course/exercise/suite.hpp"
#include "common/course/exercise/workbook.hpp"
#include "common/system/terminal.hpp"
#include "common/system/text.hpp"

#include <cstdlib>

namespace rt {

namespace {

/// The sanitizers' first error: its line, and the first places in the student's files.
std::string sanitizer_error(const std::string& output) {
    constexpr std::size_t most_places = 4;
    std::string error;
    std::string places;
    std::size_t count = 0;
    for (const std::string& line : lines_of(output)) {
        const std::size_t student = line.find("/student/");
        if (error.empty()) {
            const std::size_t file = line.find("steps/step");
            if (line.find(": runtime error: ") != std::string::npos)
                error = line.substr(file == std::string::npos ? 0 : file);
            else if (const std::size_t at = line.find("ERROR: "); at != std::string::npos)
                error = line.substr(at + 7, line.find(" on ", at) - at - 7);
        } else if (student != std::string::npos && line.find("steps/step") < student &&
                   ++count <= most_places) {
            places += "\n    " + line.substr(line.find("steps/step"));
        }
    }
    return error.empty() ? "" : error + places;
}

}  // namespace

int check_with_sanitizers(int stage) {
    const Workbook workbook(stage);
    if (workbook.files().empty()) throw not_started(stage);
    read_project_translations(step_path(stage, "sentences"));
    setenv("ASAN_OPTIONS", "handle_abort=1:detect_container_overflow=0", 1);
    const bool has_functions = workbook.files().size() > (workbook.has_trace() ? 1U : 0U);
    for (const char* const suite : {"", "_trace"}) {
        if (*suite == '\0' ? !has_functions : !workbook.has_trace()) continue;
        for (const char* const word : {"double", "float"}) {
            const std::string target =
                stage_target(stage, std::string(suite) + "_sanitized_" + word);
            build({target});
            const SuiteResult result = run_suite(target);
            std::string error = sanitizer_error(result.output);
            if (!result.ended.empty()) error = result.ended + "\n" + error;
            if (error.empty()) continue;
            const std::string name = result.cases.empty() ? "" : result.cases.back().name;
            print_line(tr("{case}, in {precision}", {{"case", tr(name)}, {"precision", word}}));
            print_line(error);
            return 1;
        }
    }
    print_line(
        tr("The sanitizers find no error: no index out of range, no use of memory that is "
           "gone, no undefined operation."));
    return 0;
}

}  // namespace rt
