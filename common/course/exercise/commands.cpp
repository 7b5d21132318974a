#include "common/course/exercise/commands.hpp"

#include "common/course/build/project.hpp"
#include "common/course/exercise/hints.hpp"
#include "common/course/exercise/workbook.hpp"
#include "common/system/files.hpp"
#include "common/system/input_error.hpp"
#include "common/system/terminal.hpp"
#include "common/system/translation.hpp"
#include "common/system/wrap.hpp"

#include <algorithm>
#include <array>

namespace rt {

namespace {

constexpr std::array<const char*, stage_names.size()> brings = {
    to_translate("a ray through every pixel"),
    to_translate("a camera in any direction"),
    to_translate("spheres, and the closest of them"),
    to_translate("planes, and a horizon"),
    to_translate("triangles without cracks between them"),
    to_translate("squares, and the Cornell box"),
    to_translate("open cylinders"),
    to_translate("open cones"),
    to_translate("light: ambient, diffuse, specular"),
    to_translate("shadows"),
    to_translate("soft shadows of area lights"),
    to_translate("mirrors"),
    to_translate("meshes of a million triangles"),
};
static_assert(brings.back() != nullptr, "a stage has no line here");

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
        line += workbook.state() == State::untouched ? tr(brings[std::size_t(stage - 1)])
                                                     : workbook.summary();
        if (output_on_terminal()) line = shortened(line, std::max(terminal_columns() - 1, 2));
        line = mark + line;
        print_line(workbook.state() == State::done ? styled(line, Style::good)
                   : stage == current              ? styled(line, Style::bold)
                                                   : line);
    }
}

void show_next() {
    const int current = current_stage();
    const bool started = Workbook(current).state() == State::started;
    const std::string command = (started ? "check " : "start ") + std::to_string(current);
    const std::string line = tr("Next: ./course {command}, and read docs/{stage}.md",
                                {{"command", command}, {"stage", name_of(current)}});
    print(wrapped_page(line, 0));
}

void start(int stage) {
    Workbook workbook(stage);
    workbook.start();
    for (const fs::path& file : workbook.files())
        print_line(tr("yours to write: {file}",
                      {{"file", file.lexically_relative(project_folder).string()}}));
    // A hand-out in a language has its pages in that language.
    const bool is_english = !fs::exists(project_folder / "lang/default.txt");
    const std::string page = "docs/" + name_of(stage) + ".md";
    print_line(
        tr("read:           {page}\nthen:           ./course check {number}",
           {{"page", is_english ? tr("{page}", {{"page", page}}) : page}, {"number", stage}}));
}

void reset(int stage) {
    print_line(tr("your old files are kept in {folder}", {{"folder", Workbook(stage).reset()}}));
}

void show_hint(int stage, std::optional<int> level) {
    const int levels = hint_count(stage);
    if (levels == 0) throw InputError({}, tr("the hints are not part of this hand-out"));
    if (level.value_or(1) > levels)
        throw InputError({},
                         tr("this hand-out has hints up to level {level}", {{"level", levels}}));
    Workbook workbook(stage);
    Record record = workbook.record();
    if (record.hint_part != record.part) record.hint_level = 0;
    record.hint_part = record.part;
    const int shown = level.value_or(std::min(record.hint_level + 1, levels));
    record.hints += std::max(0, shown - record.hint_level);
    record.hint_level = std::max(record.hint_level, shown);
    const std::string part = record.part.empty() ? "" : ", " + tr(record.part);
    read_project_translations("docs/" + name_of(stage));
    print_line(tr("{stage}, hint {level} of {levels}",
                  {{"stage", name_of(stage) + part}, {"level", shown}, {"levels", levels}}) +
               "\n");
    print(paragraphs_translated(hint_text(stage, shown, record.part)));
    if (shown > 1)
        print_line("\n" +
                   tr("An earlier hint again: ./course hint {number} 1", {{"number", stage}}));
    workbook.remember(record);
}

int show_solution(int stage) {
    const auto files = files_in(project_folder / step_path(stage, "reference"), ".cpp");
    if (files.empty()) throw InputError({}, tr("the solutions are not part of this hand-out"));
    Workbook workbook(stage);
    Record record = workbook.record();
    ++record.solution_asked;
    workbook.remember(record);
    if (workbook.state() != State::done && record.solution_asked < 2) {
        print_line(
            tr("{stage} does not pass yet. ./course hint {number} helps; repeat the command "
               "for the solution.",
               {{"stage", name_of(stage)}, {"number", stage}}));
        return 1;
    }
    for (const auto& file : files)
        print("// " + file.lexically_relative(project_folder).string() + "\n" + read_text(file));
    return 0;
}

}  // namespace rt
