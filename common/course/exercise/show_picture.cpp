#include "common/course/exercise/commands.hpp"

#include "common/course/build/project.hpp"
#include "common/course/build/static_data.hpp"
#include "common/course/exercise/image_diff.hpp"
#include "common/image/png.hpp"
#include "common/stages/stages.hpp"
#include "common/system/files.hpp"
#include "common/system/process.hpp"
#include "common/system/terminal.hpp"
#include "common/system/text.hpp"
#include "common/system/translation.hpp"
#include "common/system/wrap.hpp"

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <future>
#include <string>
#include <vector>

namespace rt {

namespace {

constexpr std::chrono::seconds picture_limit{20};

/// More than many machines have cores, so that threads take turns at any place of a pixel.
constexpr int several_threads = 4;

/// Stage 1's loop over all pixels is called if the program has one thread.
int threads_of(int stage) {
    return stage == 1 ? 1 : several_threads;
}

/// Draws the picture with that many threads.
ProcessResult drawn(const std::string& program, const std::filesystem::path& file, Resolution size,
                    int threads) {
    std::vector<std::string> command = {
        (build_folder / program).string(),
        "--quiet",
        "-o",
        file.string(),
        "--size",
        std::to_string(size.width) + "x" + std::to_string(size.height),
        "--threads",
        std::to_string(threads)};
    return run_captured(command, picture_limit);
}

/// The share of the pixels that differ: their number is that of the small picture, and the place
/// that of the whole one.
std::string difference(const Comparison& comparison, Resolution size) {
    if (!comparison.center) return summary(comparison);
    const double percent = 100.0 * comparison.different / (double(size.width) * size.height);
    const std::string share = formatted(percent < 1 ? "%.1g" : "%.0f", percent);
    const auto [row, column] = *comparison.center;
    return tr("{share} % of the pixels differ, most around row,column {pixel}",
              {{"share", share}, {"pixel", std::to_string(row) + "," + std::to_string(column)}});
}

/// Prints the usual causes of a picture that is another one with one thread.
void show_causes_of_difference(int stage) {
    std::string shared;
    for (const StaticVariable& each : static_variables(stage, compiled_files()))
        if (!each.of_each_thread) shared += (shared.empty() ? "" : ", ") + each.name;
    const std::string cause =
        shared.empty()
            ? tr("Drawn again with one thread, your picture is another one. Look for a variable "
                 "without a value, an index out of range, a reference to what is gone, or memory "
                 "that several threads write at a time. ./course check {stage} --sanitize may find "
                 "the line.",
                 {{"stage", std::to_string(stage)}})
            : tr("Drawn again with one thread, your picture is another one. Several threads write "
                 "this static or global variable at a time: {names}",
                 {{"names", shared}});
    std::printf("%s\n", wrapped_prose(cause).c_str());
}

}  // namespace

bool show_picture(int stage, bool is_wrong) {
    constexpr int apart = 5;  // a pixel is the middle one of 5 x 5 in the whole picture
    constexpr int magnification = 3;
    const std::string name(stage_name(stage));
    const Image reference =
        read_png((project_folder / "docs/pictures/small" / (name + ".png")).string());
    const TemporaryFolder folder(build_folder);
    const std::filesystem::path file = folder.path() / "mine.png";
    const std::filesystem::path file_again = folder.path() / "again.png";
    ProcessResult ending;
    ProcessResult ending_again;
    {
        const StatusLine status(tr("drawing your picture …"));
        auto again = std::async(std::launch::async, drawn, name + "_checked", file_again,
                                reference.resolution, 1);
        ending = drawn(name + "_checked", file, reference.resolution, threads_of(stage));
        ending_again = again.get();
    }
    if (ending.out_of_time || ending.status != 0) {
        const std::string why = ending.out_of_time ? tr("the program does not end")
                                : ending.crash.empty()
                                    ? ending.output
                                    : tr("the program crashed: {crash}", {{"crash", ending.crash}});
        std::printf("\n%s\n", wrapped(tr("no picture: {why}", {{"why", why}})).c_str());
        return ending.out_of_time;
    }
    const Image mine = read_png(file.string());
    Comparison comparison = compare(mine, reference);
    if (comparison.center)
        comparison.center = {.row = comparison.center->row * apart + apart / 2,
                             .column = comparison.center->column * apart + apart / 2};
    const std::string shown = "renders/" + name + "_compare.png";
    write_png((project_folder / shown).string(), magnified(comparison.side_by_side, magnification),
              {});
    const bool has_noise = !is_wrong && stage >= soft_shadow_stage && is_noise(mine, reference);
    const std::string result = comparison.different == 0 && is_wrong
                                   ? tr("the same picture: this scene does not show what is wrong")
                               : has_noise
                                   ? tr("{difference}, as with another order of the samples: the "
                                        "means agree",
                                        {{"difference", difference(comparison, mine.resolution)}})
                                   : difference(comparison, mine.resolution);
    std::printf("\n%s\n%s\n",
                wrapped(tr("Picture: {file}, beside the reference's", {{"file", shown}})).c_str(),
                wrapped("  " + result).c_str());
    if (ending_again.out_of_time || ending_again.status != 0 ||
        read_png(file_again.string()).pixels == mine.pixels)
        return true;
    show_causes_of_difference(stage);
    return false;
}

}  // namespace rt
