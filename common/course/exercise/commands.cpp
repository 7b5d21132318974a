#include "common/course/exercise/commands.hpp"

#include "common/course/build/project.hpp"
#include "common/course/exercise/hints.hpp"
#include "common/course/exercise/workbook.hpp"
#include "common/system/files.hpp"
#include "common/system/input_error.hpp"
#include "common/system/paint.hpp"
#include "common/system/terminal.hpp"
#include "common/system/wrap.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

namespace rt {

namespace {

constexpr std::array<const char*, stage_names.size()> brings = {
    "a ray through every pixel",
    "a camera in any direction",
    "spheres, and the closest of them",
    "planes, and a horizon",
    "triangles without cracks between them",
    "squares, and the Cornell box",
    "open cylinders",
    "open cones",
    "light: ambient, diffuse, specular",
    "shadows",
    "soft shadows of area lights",
    "mirrors",
    "meshes of a million triangles",
};
static_assert(brings.back() != nullptr, "a stage has no line here");

/// The ASCII text, cut to that many columns, if the standard output is a terminal.
std::string cut(const std::string& text, int columns) {
    const auto most = std::size_t(std::max(columns, 2));
    if (!output_on_terminal() || text.size() <= most) return text;
    return text.substr(0, most - 1) + "…";
}

}  // namespace

void show_progress() {
    const int current = current_stage();
    for (int stage = 1; stage <= int(brings.size()); ++stage) {
        if (!is_here(stage)) continue;
        const Workbook workbook(stage);
        const char* mark = stage == current ? "▸" : " ";
        if (workbook.state() == State::done) mark = "✓";
        std::string line =
            (stage < 10 ? "  " : " ") + std::to_string(stage) + "  " + name_of(stage);
        line.resize(line.size() + 24 - stage_name(stage).size(), ' ');
        line += workbook.state() == State::untouched ? brings[std::size_t(stage - 1)]
                                                     : workbook.summary();
        line = mark + cut(line, terminal_columns() - 1);
        std::puts(workbook.state() == State::done ? styled(line, Style::good).c_str()
                  : stage == current              ? styled(line, Style::bold).c_str()
                                                  : line.c_str());
    }
}

void show_next() {
    const int current = current_stage();
    const bool started = Workbook(current).state() == State::started;
    const std::string line = std::string("Next: ./course ") + (started ? "check " : "start ") +
                             std::to_string(current) + ", and read docs/" + name_of(current) +
                             ".md";
    std::fputs(wrapped_page(line, 0).c_str(), stdout);
}

void start(int stage) {
    Workbook workbook(stage);
    workbook.start();
    for (const std::filesystem::path& file : workbook.files())
        std::printf("yours to write: %s\n", file.lexically_relative(project_folder).c_str());
    std::printf("read:           docs/%s.md\nthen:           ./course check %d\n",
                stage_name(stage).data(), stage);
}

void reset(int stage) {
    std::printf("your old files are kept in %s\n", Workbook(stage).reset().c_str());
}

void show_hint(int stage, std::optional<int> level) {
    const int levels = hint_count(stage);
    if (levels == 0) throw InputError({}, "the hints are not part of this hand-out");
    if (level.value_or(1) > levels)
        throw InputError({}, "this hand-out has hints up to level " + std::to_string(levels));
    Workbook workbook(stage);
    Record record = workbook.record();
    if (record.hint_part != record.part) record.hint_level = 0;
    record.hint_part = record.part;
    const int shown = level.value_or(std::min(record.hint_level + 1, levels));
    record.hints += std::max(0, shown - record.hint_level);
    record.hint_level = std::max(record.hint_level, shown);
    const std::string part = record.part.empty() ? "" : ", " + record.part;
    std::printf("%s%s, hint %d of %d\n\n%s", stage_name(stage).data(), part.c_str(), shown,
                levels, hint_text(stage, shown, record.part).c_str());
    if (shown > 1) std::printf("\nAn earlier hint again: ./course hint %d 1\n", stage);
    workbook.remember(record);
}

int show_solution(int stage) {
    const auto files = files_in(project_folder / step_path(stage, "reference"), ".cpp");
    if (files.empty()) throw InputError({}, "the solutions are not part of this hand-out");
    Workbook workbook(stage);
    Record record = workbook.record();
    ++record.solution_asked;
    workbook.remember(record);
    if (workbook.state() != State::done && record.solution_asked < 2) {
        std::printf(
            "%s does not pass yet. ./course hint %d helps; repeat the command for the solution.\n",
            stage_name(stage).data(), stage);
        return 1;
    }
    for (const auto& file : files)
        std::printf("// %s\n%s", file.lexically_relative(project_folder).c_str(),
                    read_text(file).c_str());
    return 0;
}

}  // namespace rt
