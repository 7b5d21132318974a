// Reads every scene of the corpus, strict and lenient, in both precisions, and compares the result
// with the published format.

#include "tests/programs/corpus/outcome.hpp"
#include "tests/programs/corpus/verdicts.hpp"

#include "common/system/input_error.hpp"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <filesystem>
#include <iostream>

namespace {

/// The required percentage of agreement of strict reading, for files with a clear verdict.
constexpr double strict_bar = 99;
/// The required percentage of accepted files in lenient reading, for files that are not wrong on
/// purpose.
constexpr double lenient_bar = 95;

struct Count {
    int accepted = 0;
    int refused = 0;

    void add(bool accept) { ++(accept ? accepted : refused); }
    [[nodiscard]] int all() const { return accepted + refused; }
};

double percent(int part, int whole) {
    return whole == 0 ? 100 : 100.0 * part / whole;
}

/// The result of one precision.
struct Tally {
    std::map<std::string, Count> strict;   ///< by class
    std::map<std::string, Count> lenient;  ///< by class
    Count agreement;                       ///< accepted: strict reading and verdict agree
    Count ordinary;                        ///< lenient reading of files not meant to be wrong
    int unexplained = 0;
};

using Reader = rt::Outcome (*)(const std::string&, bool);

/// True if strict reading agrees with the verdict; any result is accepted for an extended file.
bool agrees(const rt::Verdict& verdict, const rt::Outcome& strict) {
    if (verdict.kind == "extended") return true;
    return strict.accepted == (verdict.kind != "invalid");
}

void print_disagreement(const rt::Verdict& verdict, const rt::Outcome& strict,
                        const std::string& why) {
    const std::string place = verdict.file + ":" + verdict.line + ": " + verdict.kind + " (" +
                              verdict.reason + " " + verdict.note + ")";
    std::cout << "  " << (strict.accepted ? place + ", but accepted" : strict.message) << "\n    "
              << why << "\n";
}

Tally tally(const std::filesystem::path& folder, const std::vector<rt::Verdict>& verdicts,
            const std::map<std::string, std::string>& explanations, Reader read) {
    Tally result;
    for (const rt::Verdict& verdict : verdicts) {
        const std::string file = (folder / verdict.file).string();
        const rt::Outcome strict = read(file, true);
        const rt::Outcome lenient = read(file, false);
        result.strict[verdict.kind].add(strict.accepted);
        result.lenient[verdict.kind].add(lenient.accepted);
        if (verdict.ordinary) result.ordinary.add(lenient.accepted);
        const bool agreed = agrees(verdict, strict);
        if (verdict.kind != "extended") result.agreement.add(agreed);
        const auto explanation = explanations.find(verdict.file);
        const bool explained = explanation != explanations.end();
        if (agreed && explained) std::cout << "  " << file << ": explained, but it agrees\n";
        if (!agreed) print_disagreement(verdict, strict, explained ? explanation->second : "?");
        if (agreed == explained) ++result.unexplained;
    }
    return result;
}

void print(const Tally& tally) {
    std::printf("  %-10s %18s %18s\n", "", "strict", "lenient");
    std::printf("  %-10s %9s %8s %9s %8s\n", "class", "accepted", "refused", "accepted", "refused");
    for (const auto& [kind, strict] : tally.strict) {
        const Count lenient = tally.lenient.at(kind);
        std::printf("  %-10s %9d %8d %9d %8d\n", kind.c_str(), strict.accepted, strict.refused,
                    lenient.accepted, lenient.refused);
    }
    std::printf("  strict agrees on %d of %d files with a clear verdict: %.2f %% (bar %.0f %%)\n",
                tally.agreement.accepted, tally.agreement.all(),
                percent(tally.agreement.accepted, tally.agreement.all()), strict_bar);
    std::printf("  lenient reads %d of %d ordinary files: %.2f %% (bar %.0f %%)\n",
                tally.ordinary.accepted, tally.ordinary.all(),
                percent(tally.ordinary.accepted, tally.ordinary.all()), lenient_bar);
    std::fflush(stdout);
}

bool passes(const Tally& tally) {
    return tally.unexplained == 0 &&
           percent(tally.agreement.accepted, tally.agreement.all()) >= strict_bar &&
           percent(tally.ordinary.accepted, tally.ordinary.all()) >= lenient_bar;
}

void print_refused(const std::filesystem::path& folder, const std::vector<rt::Verdict>& verdicts,
                   bool strict) {
    for (const rt::Verdict& verdict : verdicts) {
        const auto outcome = rt::f64::read_outcome((folder / verdict.file).string(), strict);
        if (!outcome.accepted) std::cout << outcome.message << "\n";
    }
}

int check(const std::filesystem::path& folder, const std::filesystem::path& explanations_file) {
    const auto verdicts = rt::read_verdicts(folder / "verdicts.tsv");
    const auto explanations = rt::read_explanations(explanations_file);
    bool passed = true;
    for (const auto& [name, read] : {std::pair<const char*, Reader>{"float", rt::f32::read_outcome},
                                     {"double", rt::f64::read_outcome}}) {
        std::cout << name << ": disagreements, and why\n" << std::flush;
        const Tally result = tally(folder, verdicts, explanations, read);
        print(result);
        passed = passed && passes(result);
    }
    std::cout << (passed ? "passed\n" : "FAILED\n");
    return passed ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"Reads the corpus of real .rt scenes and compares with its verdicts."};
    std::string folder;
    std::string explanations;
    bool list_lenient = false;
    bool list_strict = false;
    app.add_option("folder", folder, "the corpus: verdicts.tsv and files/")
        ->required()
        ->check(CLI::ExistingDirectory);
    app.add_option("--explained", explanations, "disagreements.tsv: file and why")
        ->required()
        ->check(CLI::ExistingFile);
    app.add_flag("--list-lenient", list_lenient, "only the errors of lenient reading");
    app.add_flag("--list-strict", list_strict, "only the errors of strict reading");
    CLI11_PARSE(app, argc, argv);
    try {
        if (!list_lenient && !list_strict) return check(folder, explanations);
        const auto verdicts = rt::read_verdicts(std::filesystem::path(folder) / "verdicts.tsv");
        print_refused(folder, verdicts, list_strict);
        return 0;
    } catch (const rt::InputError& error) {
        std::cerr << error.what() << "\n";
        return 2;
    }
}
