// Renders every scene of the corpus that lenient reading accepts, in both precisions. The valid
// scenes must be among them, and no pixel may be NaN. Lists the slow scenes, and stores the
// pictures for a manual review if a folder is given.

#include "tests/programs/corpus/drawing.hpp"
#include "tests/programs/corpus/verdicts.hpp"

#include "common/image/png.hpp"
#include "common/system/input_error.hpp"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <filesystem>
#include <iostream>
#include <utility>

namespace {

constexpr rt::Resolution size{.width = 160, .height = 120};
/// Processor time; longer is suspicious for so small a picture.
constexpr double long_time = 2;

using Draw = rt::Drawing (*)(const std::string&, rt::Resolution);

/// The result of one precision.
struct Tally {
    int rendered = 0;
    int valid = 0;  ///< among these
    int wrong = 0;  ///< valid but refused or slow, or with a pixel that is not a number
    double seconds = 0;
};

/// The scene's path with "__" for "/": one folder contains all pictures.
std::string picture_name(std::string file, const std::string& precision) {
    for (std::size_t slash = file.find('/'); slash != std::string::npos; slash = file.find('/'))
        file.replace(slash, 1, "__");
    return file + "." + precision + ".png";
}

bool is_valid(const rt::Verdict& verdict) {
    return verdict.kind == "valid-old" || verdict.kind == "valid-new";
}

void add(Tally& tally, const rt::Verdict& verdict, const rt::Drawing& drawing) {
    if (!drawing.refusal.empty()) {
        if (!is_valid(verdict)) return;
        std::printf("  %s\n", drawing.refusal.c_str());
        ++tally.wrong;
        return;
    }
    ++tally.rendered;
    if (is_valid(verdict)) ++tally.valid;
    tally.seconds += drawing.seconds;
    if (drawing.not_a_number > 0) {
        std::printf("  %s: %lld pixels are not a number\n", verdict.file.c_str(),
                    static_cast<long long>(drawing.not_a_number));
        ++tally.wrong;
    }
    if (drawing.seconds <= long_time) return;
    std::printf("  %s: %.1f s\n", verdict.file.c_str(), drawing.seconds);
    if (is_valid(verdict)) ++tally.wrong;
}

Tally draw_all(const std::filesystem::path& folder, const std::string& pictures,
               const std::string& precision, Draw draw) {
    Tally tally;
    for (const rt::Verdict& verdict : rt::read_verdicts(folder / "verdicts.tsv")) {
        const rt::Drawing drawing = draw((folder / verdict.file).string(), size);
        add(tally, verdict, drawing);
        if (pictures.empty() || !drawing.refusal.empty()) continue;
        const std::string name = picture_name(verdict.file, precision);
        rt::write_png((std::filesystem::path(pictures) / name).string(), drawing.image, {});
    }
    return tally;
}

bool check(const std::filesystem::path& folder, const std::string& pictures) {
    bool passed = true;
    for (const auto& [precision, draw] :
         {std::pair<const char*, Draw>{"float", rt::f32::draw}, {"double", rt::f64::draw}}) {
        std::printf("%s: wrong, or longer than %.0f s\n", precision, long_time);
        const Tally tally = draw_all(folder, pictures, precision, draw);
        std::printf("  %d scenes drawn, %d of them valid, %d wrong, %.1f s\n", tally.rendered,
                    tally.valid, tally.wrong, tally.seconds);
        passed = passed && tally.wrong == 0;
    }
    std::puts(passed ? "passed" : "FAILED");
    return passed;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"Draws the corpus of real .rt scenes."};
    std::string folder;
    std::string pictures;
    app.add_option("folder", folder, "the corpus: verdicts.tsv and files/")
        ->required()
        ->check(CLI::ExistingDirectory);
    app.add_option("--keep", pictures, "the folder for the pictures; none are kept without it");
    CLI11_PARSE(app, argc, argv);
    std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
    try {
        return check(folder, pictures) ? 0 : 1;
    } catch (const rt::InputError& error) {
        std::cerr << error.what() << "\n";
        return 2;
    }
}
