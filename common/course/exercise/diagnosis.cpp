#include "common/course/exercise/diagnosis.hpp"

#include "common/course/build/build.hpp"
#include "common/course/build/project.hpp"
#include "common/course/exercise/telling_case.hpp"
#include "common/system/process.hpp"
#include "common/system/terminal.hpp"
#include "common/system/translation.hpp"

#include <chrono>

namespace rt {

namespace {

constexpr std::chrono::seconds time_limit{20};

std::string program(const std::string& name) {
    return (build_folder / name).string();
}

ProcessResult diagnosed(const Command& command) {
    const StatusLine status(tr("comparing with known mistakes …"));
    return run_captured(command, time_limit);
}

/// The output of `diagnose`: "mistake: name: sentence", "always: sentence" and other sentences,
/// then "smallest: call" and its indented lines.
Diagnosis read_diagnosis(const std::string& output) {
    Diagnosis diagnosis;
    for (const std::string& line : lines_of(output)) {
        const auto mistake = after("mistake: ", line);
        if (const auto smallest = after("smallest: ", line))
            diagnosis.smallest = *smallest + "\n";
        else if (!diagnosis.smallest.empty())
            diagnosis.smallest += line + "\n";
        else if (const auto colon = mistake.value_or("").find(": "); colon != std::string::npos) {
            diagnosis.names.push_back(mistake->substr(0, colon));
            diagnosis.sentences.push_back(mistake->substr(colon + 2));
        } else if (!line.empty())
            diagnosis.sentences.push_back(after("always: ", line).value_or(line));
    }
    return diagnosis;
}

}  // namespace

Diagnosis diagnosis_of(int stage, const fs::path& report,
                       const std::vector<std::string>& unwritten) {
    const std::string student = stage_target(stage, "_worker_double");
    const std::string reference = stage_target(stage, "_reference_worker");
    if (!try_build({"diagnose", student, reference}).succeeded) return {};  // not on this system
    const std::string slice = "renders/" + stage_target(stage, "_slice.svg");
    const fs::path drawing = project_folder / slice;
    std::error_code none;
    fs::remove(drawing, none);
    Command command = {
        program("diagnose"),
        (project_folder / mistakes_folder / stage_name(stage) / "probes.txt").string(),
        program(student),
        program(reference),
        report.string(),
        drawing.string()};
    command.insert(command.end(), unwritten.begin(), unwritten.end());
    const ProcessResult ending = diagnosed(command);
    if (ending.out_of_time || ending.status != 1) return {};
    Diagnosis diagnosis = read_diagnosis(ending.output);
    if (fs::exists(drawing)) {
        write_text(drawing, tr_lines(read_text(drawing)));
        diagnosis.drawing = slice;
    }
    return diagnosis;
}

}  // namespace rt
