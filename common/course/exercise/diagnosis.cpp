#include "common/course/exercise/diagnosis.hpp"

#include "common/course/build/build.hpp"
#include "common/course/build/project.hpp"
#include "common/system/files.hpp"
#include "common/system/paint.hpp"
#include "common/system/process.hpp"
#include "common/system/status_line.hpp"
#include "common/system/wrap.hpp"

#include <cstdio>

namespace rt {

namespace {

constexpr std::chrono::seconds time_limit{20};

std::string program(const std::string& name) {
    return (build_folder / name).string();
}

ProcessResult diagnosed(const Command& command) {
    const StatusLine status("comparing with known mistakes …");
    return run_captured(command, time_limit);
}

}  // namespace

void show_diagnosis(int stage, const std::filesystem::path& report,
                    const std::set<std::string>& unwritten) {
    const std::string student = stage_target(stage, "_worker_double");
    const std::string reference = stage_target(stage, "_reference_worker");
    if (!try_build({"diagnose", student, reference}).succeeded) return;  // not on this system
    const std::string slice = "renders/" + stage_target(stage, "_slice.svg");
    const std::filesystem::path drawing = project_folder / slice;
    std::error_code none;
    std::filesystem::remove(drawing, none);
    Command command = {
        program("diagnose"),
        (project_folder / "tests/mistakes" / stage_name(stage) / "probes.txt").string(),
        program(student),
        program(reference),
        report.string(),
        drawing.string()};
    command.insert(command.end(), unwritten.begin(), unwritten.end());
    const ProcessResult ending = diagnosed(command);
    if (ending.out_of_time || ending.status != 1) return;
    std::puts("");
    for (const std::string& line : lines_of(ending.output)) {
        const bool mistake = line.rfind("mistake: ", 0) == 0;
        const std::string shown = wrapped(line);
        std::printf("%s\n", mistake ? styled(shown, Style::bold).c_str() : shown.c_str());
    }
    if (std::filesystem::exists(drawing)) std::printf("drawn:     %s\n", slice.c_str());
}

}  // namespace rt
