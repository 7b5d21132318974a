
#include "common/course/exercise/image_diff.hpp"
#include "common/course/own/own.hpp"
#include "common/image/png.hpp"
#include "common/system/input_error.hpp"
#include "common/system/process.hpp"
#include "common/system/terminal.hpp"
#include "common/system/translation.hpp"

#include <cctype>
#include <fstream>
#include <optional>

namespace rt {

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
                                {{"seconds", limit.count()}}));
    if (!ending.crash.empty())
        throw InputError({},
                         tr("the program crashed: {signal}", {{"signal", tr_text(ending.crash)}}));
    const std::vector<std::string> printed = lines_of(ending.output);
    if (ending.status != 0)
        throw InputError({},
                         tr("the program ended with status {status}", {{"status", ending.status}}) +
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
                           {{"number", comparison.different},
                            {"all", reference.pixels.size()},
                            {"tolerated", tolerated},
                            {"most", comparison.most},
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
        print_line(styled(line, judgment.agrees ? Style::good : Style::bad));
        all_agree = all_agree && judgment.agrees;
    }
    if (all_agree) print_line(tr("Your ray tracer draws what the reference draws."));
    return all_agree ? 0 : 1;
}

namespace {

constexpr int brightest = 255;
constexpr std::size_t channels = 3;

class PpmReader {
public:
    PpmReader(const std::string& file, Resolution expected)
        : name_(fs::path(file).filename().string()), text_(read_text(file)), expected_(expected) {}

    [[nodiscard]] Image read() {
        const std::string kind = text_.substr(0, 2);
        if (kind != "P6" && kind != "P3") fail(tr("is not a PPM: it does not start with P6 or P3"));
        at_ = 2;
        const int width = header(to_translate("has no width after {kind}"));
        const int height = header(to_translate("has no height after {kind}"));
        if (width != expected_.width || height != expected_.height)
            fail(tr("has the size {size}, not the scene's, {expected}",
                    {{"size", std::to_string(width) + " x " + std::to_string(height)},
                     {"expected", std::to_string(expected_.width) + " x " +
                                      std::to_string(expected_.height)}}));
        const int most = header(to_translate("has no largest level after {kind}"));
        if (most != brightest)
            fail(tr("has the largest level {level}, not 255", {{"level", most}}));
        ++at_;  // exactly one blank before the colors
        Image image(expected_);
        kind == "P6" ? read_bytes(image) : read_numbers(image);
        return image;
    }

private:
    [[noreturn]] void fail(const std::string& what) const { throw InputError({name_}, what); }

    /// The next decimal number; nothing if something else follows, or a number of seven digits.
    std::optional<int> number() {
        constexpr std::size_t most_digits = 6;
        while (at_ < text_.size() && (std::isspace(byte(at_)) != 0 || text_[at_] == '#'))
            at_ = text_[at_] == '#' ? std::min(text_.find('\n', at_), text_.size()) : at_ + 1;
        const std::size_t start = at_;
        while (at_ < text_.size() && std::isdigit(byte(at_)) != 0) ++at_;
        if (at_ == start || at_ - start > most_digits) return std::nullopt;
        return std::stoi(text_.substr(start, at_ - start));
    }

    int header(const std::string& missing) {
        const std::optional<int> value = number();
        if (!value) fail(tr(missing, {{"kind", text_.substr(0, 2)}}));
        return *value;
    }

    void read_bytes(Image& image) {
        const std::size_t wanted = channels * image.pixels.size();
        const std::size_t there = text_.size() - std::min(at_, text_.size());
        if (there != wanted)
            fail(tr("has {number} bytes of colors, not {all}, three for each pixel",
                    {{"number", there}, {"all", wanted}}));
        for (Rgb& pixel : image.pixels)
            for (std::uint8_t& level : pixel) level = byte(at_++);
    }

    void read_numbers(Image& image) {
        for (Rgb& pixel : image.pixels)
            for (std::uint8_t& level : pixel) {
                const std::optional<int> value = number();
                if (!value || *value > brightest)
                    fail(tr("has no {number} numbers from 0 to 255, three for each pixel",
                            {{"number", channels * image.pixels.size()}}));
                level = static_cast<std::uint8_t>(*value);
            }
    }

    [[nodiscard]] unsigned char byte(std::size_t at) const {
        return static_cast<unsigned char>(text_[at]);
    }

    std::string name_;
    std::string text_;
    Resolution expected_;
    std::size_t at_ = 0;
};

}  // namespace

Image read_ppm(const std::string& file, Resolution expected) {
    return PpmReader(file, expected).read();
}

}  // namespace rt
