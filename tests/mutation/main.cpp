// mutate [STAGE...]
//
// Changes a stage's reference in one place at a time and runs the stage's suite on it. A surviving
// mutant shows an untested property, unless survivors.txt explains why it is equivalent. Exit
// status 1 if an unlisted mutant survives, or a listed one does not.
#include "tests/mutation/mutants.hpp"
#include "tests/mutation/workshop.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <iostream>
#include <map>
#include <random>
#include <sstream>

namespace mutation {

namespace {

struct Options {
    std::vector<std::string> stages;
    std::size_t sample = 0;
    unsigned seed = 2021;
    bool every_case = false;
};

struct Tally {
    int mutants = 0;
    int not_compiled = 0;
    int same_code = 0;
    int killed = 0;
    int equivalent = 0;
    int accuracy = 0;
    int unexplained = 0;
    int wrongly_listed = 0;  ///< killed, of the same code, or gone
};

/// The fraction of killed mutants, of those that are not equivalent to the reference.
double score(const Tally& tally) {
    const int wrong = tally.killed + tally.accuracy + tally.unexplained;
    return wrong == 0 ? 100 : 100.0 * tally.killed / wrong;
}

/// The fraction of all mutants that change the code.
double raw_score(const Tally& tally) {
    const int all = tally.killed + tally.accuracy + tally.unexplained + tally.equivalent;
    return all == 0 ? 100 : 100.0 * tally.killed / all;
}

void print_survivor(const std::string& stage, const Mutant& mutant, const std::string& reason) {
    std::cout << stage << " " << mutant.function << "\n- " << mutant.before << "\n+ "
              << mutant.after << "\n"
              << reason << " (line " << mutant.line << ")\n\n";
}

struct Kills {
    int all = 0;
    int alone = 0;  ///< no other case failed
};

/// In a run that stops at the first failure, a case after others may have no kills.
void print_cases(const std::map<std::string, Kills>& cases, bool every_case) {
    std::printf(every_case ? "  kills  alone\n" : "  kills first\n");
    for (const auto& [name, kills] : cases) {
        std::printf("%7d", kills.all);
        if (every_case) std::printf("%7d", kills.alone);
        std::printf("  %s\n", name.c_str());
    }
    std::printf("\n");
    std::fflush(stdout);
}

std::filesystem::path reference_of(const std::string& stage) {
    const std::filesystem::path name = stage.substr(stage.find('_') + 1) + ".cpp";
    return std::filesystem::path(RAYSTEPS_ROOT) / "steps" / stage / "reference" / name;
}

/// Mutants in the stage's list that its reference no longer generates.
int print_gone(const std::string& stage, const std::vector<Mutant>& mutants,
               const std::vector<Survivor>& listed) {
    int gone = 0;
    for (const Survivor& one : listed) {
        const auto is_it = [&](const Mutant& mutant) { return find({one}, stage, mutant); };
        if (one.stage != stage || std::any_of(mutants.begin(), mutants.end(), is_it)) continue;
        std::cout << "listed, but gone: " << stage << " " << one.function << "\n+ " << one.after
                  << "\n\n";
        ++gone;
    }
    return gone;
}

void count(Tally& tally, const std::string& stage, const Mutant& mutant, const Survivor* listed,
           Fate fate) {
    if (fate == Fate::not_compiled) ++tally.not_compiled;
    if (fate == Fate::same_code) ++tally.same_code;
    if (fate == Fate::killed) ++tally.killed;
    if (fate != Fate::survived && listed) {
        ++tally.wrongly_listed;
        print_survivor(stage, mutant, "LISTED, but it does not survive");
    } else if (fate == Fate::survived) {
        ++(!listed                        ? tally.unexplained
           : listed->kind == "equivalent" ? tally.equivalent
                                          : tally.accuracy);
        print_survivor(stage, mutant, listed ? listed->kind + ": " + listed->reason : "SURVIVES");
    }
}

Tally mutate(const std::string& stage, const std::vector<Survivor>& listed,
             const Options& options) {
    const std::string reference = rt::read_text(reference_of(stage));
    std::vector<Mutant> mutants = mutants_of(reference);
    Tally tally;
    tally.wrongly_listed = print_gone(stage, mutants, listed);
    if (options.sample > 0) {
        std::shuffle(mutants.begin(), mutants.end(), std::mt19937(options.seed));
        mutants.resize(std::min(mutants.size(), options.sample));
    }
    tally.mutants = int(mutants.size());
    const BuildDirectory workshop(stage, reference, options.every_case);
    std::map<std::string, Kills> cases;
    for (const std::string& name : workshop.cases()) cases[name] = {};
    for (const Mutant& mutant : mutants) {
        const Outcome outcome = workshop.judge(mutant.source);
        count(tally, stage, mutant, find(listed, stage, mutant), outcome.fate);
        for (const std::string& killer : outcome.killers) {
            ++cases[killer].all;
            if (outcome.killers.size() == 1) ++cases[killer].alone;
        }
    }
    print_cases(cases, options.every_case);
    return tally;
}

void print(const std::string& name, const Tally& tally) {
    std::printf("| %s | %d | %d | %d | %d | %d | %d | %d | %.1f | %.1f |\n", name.c_str(),
                tally.mutants, tally.not_compiled, tally.same_code, tally.killed, tally.equivalent,
                tally.accuracy, tally.unexplained, score(tally), raw_score(tally));
}

void add(Tally& sum, const Tally& tally) {
    for (int Tally::*part :
         {&Tally::mutants, &Tally::not_compiled, &Tally::same_code, &Tally::killed,
          &Tally::equivalent, &Tally::accuracy, &Tally::unexplained, &Tally::wrongly_listed})
        sum.*part += tally.*part;
}

int mutate(const Options& options) {
    const auto listed = read_survivors(RAYSTEPS_ROOT "/tests/mutation/survivors.txt");
    std::map<std::string, Tally> tallies;
    for (const std::string& stage : options.stages) tallies[stage] = mutate(stage, listed, options);
    std::printf(
        "| Stage | Mutants | Do not compile | Same code | Killed | Equivalent | Accuracy only | "
        "Unexplained | Score | Of all |\n|---|---|---|---|---|---|---|---|---|---|\n");
    Tally sum;
    for (const auto& [stage, tally] : tallies) {
        print(stage, tally);
        add(sum, tally);
    }
    print("all", sum);
    return sum.unexplained + sum.wrongly_listed == 0 ? 0 : 1;
}

}  // namespace

}  // namespace mutation

int main(int argc, char** argv) {
    CLI::App app{
        "Changes references in one place at a time, and runs the stage's suite on each change."};
    mutation::Options options;
    app.add_option("stage", options.stages, "such as step05_triangle; default: all of them");
    app.add_option("--sample", options.sample, "number of mutants of each stage; 0: all");
    app.add_option("--seed", options.seed, "which ones")->capture_default_str();
    app.add_flag("--every-case", options.every_case, "do not stop at the first case that fails");
    CLI11_PARSE(app, argc, argv);
    if (options.stages.empty()) {
        std::istringstream all(RAYSTEPS_STAGES);
        options.stages.assign(std::istream_iterator<std::string>(all), {});
    }
    try {
        return mutation::mutate(options);
    } catch (const std::exception& error) {
        std::cerr << "error: " << error.what() << '\n';
        return 2;
    }
}
