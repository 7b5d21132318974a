#include "common/course/own/check_own.hpp"

#include "common/course/exercise/image_diff.hpp"
#include "common/course/own/lay_out.hpp"
#include "common/course/own/ppm.hpp"
#include "common/image/png.hpp"
#include "common/system/files.hpp"
#include "common/system/input_error.hpp"
#include "common/system/paint.hpp"
#include "common/system/process.hpp"
#include "common/system/translation.hpp"

#include <cstdio>
#include <fstream>

namespace rt {

namespace fs = std::filesystem;

namespace {

/// Scenes of spheres, planes, ambient light and lights alone, without options.
constexpr const char* scenes[] = {"step03_sphere", "step04_plane", "your_own"};

constexpr int tolerated = 4;  ///< levels of 255: other formulas round in another way
/// The number of pixels of which one may differ by more: at an outline, rounding decides what is
/// hit.
constexpr int pixels_for_one = 1000;

constexpr const char* most_output = "131072";  ///< of 512 bytes: a picture has less than 1 MiB

/// Throws InputError with the reason if a program leaves no picture.
void run(const Command& program, const fs::path& picture, std::chrono::seconds limit) {
    Command command = {"sh", "-c", std::string("ulimit -f ") + most_output + "; exec \"$@\"", "sh"};
    command.insert(command.end(), program.begin(), program.end());
    const ProcessResult ending = run_captured(command, limit);
    if (ending.out_of_time)
        throw InputError({}, tr("the program did not end within {seconds} s; --seconds sets "
                                "another limit",
                                {{"seconds", std::to_string(limit.count())}}));
    if (!ending.crash.empty())
        throw InputError({},
                         tr("the program crashed: {signal}", {{"signal", tr_text(ending.crash)}}));
    const std::vector<std::string> printed = lines_of(ending.output);
    if (ending.status != 0)
        throw InputError({}, tr("the program ended with status {status}",
                                {{"status", std::to_string(ending.status)}}) +
                                 (printed.empty() ? "" : ": " + printed.front()));
    if (!fs::is_regular_file(picture))
        throw InputError({},
                         tr("the program ended without a picture: it must write to the file that "
                            "its second argument names"));
}

bool is_png(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return in.get() == 0x89 && in.get() == 'P';
}

Image read_picture(const fs::path& file, Resolution expected) {
    if (!is_png(file)) return read_ppm(file.string(), expected);
    Image image = read_png(file.string());
    if (image.resolution.width != expected.width || image.resolution.height != expected.height)
        throw InputError({file.filename().string()}, tr("has the size of another scene"));
    return image;
}

/// The comparison in one line, and whether the pictures agree.
struct Judgment {
    bool agrees = false;
    std::string sentence;
};

Judgment judge(const OwnCheck& check, const std::string& scene, const Image& reference) {
    const std::string input = (check.project / "scenes" / (scene + ".rt")).string();
    const TemporaryFolder folder;
    const fs::path picture = folder.path() / "picture.ppm";
    Image mine;
    try {
        run({check.program.string(), input, picture.string()}, picture, check.limit);
        mine = read_picture(picture, reference.resolution);
    } catch (const InputError& error) {
        return {.agrees = false, .sentence = tr_text(error.what())};
    }
    const Comparison comparison = compare(mine, reference, tolerated);
    const std::string shown = "renders/own_" + scene + ".png";
    write_png((check.project / shown).string(), comparison.side_by_side, {});
    return {.agrees = comparison.different <= int(reference.pixels.size()) / pixels_for_one,
            .sentence = tr("{number} of {all} pixels differ by more than {tolerated} levels; the "
                           "largest difference is {most}: {file}",
                           {{"number", std::to_string(comparison.different)},
                            {"all", std::to_string(reference.pixels.size())},
                            {"tolerated", std::to_string(tolerated)},
                            {"most", std::to_string(comparison.most)},
                            {"file", shown}})};
}

Image reference_picture(const OwnCheck& check, const std::string& scene) {
    const TemporaryFolder folder;
    const fs::path picture = folder.path() / "picture.png";
    const ProcessResult ending = run_captured(
        {check.reference.string(), (check.project / "scenes" / (scene + ".rt")).string(), "--quiet",
         "-o", picture.string()},
        std::chrono::minutes(5));
    if (ending.status != 0) throw ProgramError(ending.output);
    return read_png(picture.string());
}

}  // namespace

fs::path own_program(const fs::path& folder) {
    if (folder.empty()) throw InputError({}, tr("own: expected a name, not \"\""));
    const fs::path program = folder / "build/tracer";
    if (fs::is_regular_file(program)) return fs::absolute(program);
    throw InputError({program.string()}, tr("no such program: build it with {command}",
                                            {{"command", own_build_command(folder)}}));
}

int check_own(const OwnCheck& check) {
    bool all_agree = true;
    for (const std::string scene : scenes) {
        const Judgment judgment = judge(check, scene, reference_picture(check, scene));
        const std::string line = (judgment.agrees ? "✓ " : "✗ ") + scene + ": " + judgment.sentence;
        std::puts(styled(line, judgment.agrees ? Style::good : Style::bad).c_str());
        all_agree = all_agree && judgment.agrees;
    }
    if (all_agree) std::puts(tr("Your ray tracer draws what the reference draws.").c_str());
    return all_agree ? 0 : 1;
}

}  // namespace rt
