#include "common/course/authoring/commands.hpp"

#include "common/course/build/build.hpp"
#include "common/course/build/project.hpp"
#include "common/system/files.hpp"
#include "common/system/input_error.hpp"
#include "common/system/process.hpp"
#include "common/system/terminal.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>

namespace rt {

namespace {

/// A CSV file, and the programs measure_… that print it, in turns.
struct File {
    std::string study;
    std::string name;
    std::vector<std::string> programs;
    int turns;            ///< more than one, where time is measured
    double seconds;       ///< of one turn, on the machine of docs/reference/accuracy.md
    bool meshes = false;  ///< true if it needs OpenMesh
};

const std::vector<File> tables = {
    {"shapes", "shape_costs", {"costs_float", "costs_double"}, 11, 2},
    {"shapes", "shape_errors", {"errors_float", "errors_double"}, 1, 100},
    {"contact", "contact", {"contact_float", "contact_double"}, 1, 2},
    {"penumbra", "penumbra", {"penumbra"}, 3, 9},
    {"hierarchy", "hierarchy", {"hierarchy"}, 3, 1},
    {"mirrors", "mirrors", {"mirrors"}, 3, 8, true},
    {"meshes", "decimation", {"decimation"}, 3, 4, true},
    {"pixels", "pixels", {"pixels"}, 1, 80, true},
    {"front", "front", {"front"}, 1, 650, true},
    {"sources", "sources", {"sources"}, 1, 60, true},
    {"pictures", "pictures", {"pictures"}, 3, 18, true},
    {"memory", "memory", {"memory_float", "memory_double"}, 1, 1, true},
    {"rounding", "input_rounding", {"input_rounding"}, 1, 25, true},
    {"analytic", "analytic", {"analytic"}, 1, 5},
    {"formats", "formats", {"formats"}, 1, 5},
    {"flags",
     "flags",
     {"flags_o2", "flags_o3", "flags_native", "flags_contract", "flags_fast_math", "flags_flush"},
     3,
     12},
};

/// "measuring: 45 %, 80 s left"
class Meter {
public:
    explicit Meter(double all) : all_(all) {}

    /// Finishes the previous part, and starts one with this expected duration.
    void begin(double seconds) {
        done_ += part_;
        part_ = seconds;
        begun_ = Clock::now();
        explain();
    }

    void explain() {
        const Clock::time_point now = Clock::now();
        const double slower = done_ > 0 ? Seconds(begun_ - start_).count() / done_ : 1;
        const double done = done_ + std::min(Seconds(now - begun_).count() / slower, part_);
        status_.show(formatted("measuring: %.0f %%, %.0f s left", 100 * done / all_,
                               slower * (all_ - done)));
    }

private:
    using Clock = std::chrono::steady_clock;
    using Seconds = std::chrono::duration<double>;

    StatusLine status_{"measuring …"};
    double all_;
    double done_ = 0;
    double part_ = 0;
    Clock::time_point start_ = Clock::now();
    Clock::time_point begun_ = start_;
};

/// All that a program prints. Throws ProgramError if it fails.
std::string output_of(const std::string& program, Meter& meter) {
    std::string output;
    const auto hear = [&](std::string_view piece) {
        output += piece;
        if (piece.empty()) meter.explain();
    };
    if (run_heard({(build_folder / program).string()}, Streams::output, hear) != 0)
        throw ProgramError("error: " + program + " fails\n");
    return output;
}

/// The lines of every program's table under one heading.
std::string measured(const File& file, Meter& meter) {
    std::string all;
    for (int turn = 0; turn < file.turns; ++turn)
        for (const std::string& program : file.programs) {
            meter.begin(file.seconds / double(file.programs.size()));
            const std::string table = output_of("measure_" + program, meter);
            all += all.empty() ? table : table.substr(table.find('\n') + 1);
        }
    return all;
}

std::vector<File> chosen(const std::vector<std::string>& names) {
    std::vector<File> found;
    for (const File& file : tables)
        if (names.empty() || std::ranges::count(names, file.study) > 0) found.push_back(file);
    for (const std::string& name : names)
        if (std::ranges::none_of(tables, [&](const File& file) { return file.study == name; })) {
            std::string all;
            for (const File& file : tables)
                if (all.find(file.study) == std::string::npos)
                    all += std::string(all.empty() ? "" : ", ") + file.study;
            throw InputError({}, "no study \"" + name + "\": there are " + all);
        }
    return found;
}

/// True if the program exists, and succeeds.
bool can_run(const Command& command) {
    try {
        return run_captured(command, std::chrono::minutes(1)).status == 0;
    } catch (const InputError&) {
        return false;
    }
}

}  // namespace

int measure(const std::vector<std::string>& names) {
    const std::vector<File> studied = chosen(names);
    const fs::path docs = project_folder / "docs";
    const auto needs_meshes = [](const File& file) { return file.meshes; };
    if (!has_oracle)
        throw InputError({}, "measure needs Boost: libboost-dev, or what your system calls it");
    if (!has_meshes && std::ranges::any_of(studied, needs_meshes))
        throw InputError({},
                         "measure needs OpenMesh: libopenmesh-dev; without it there are shapes, "
                         "contact, penumbra and hierarchy");
    const std::string draw = (docs / "accuracy/plots/draw.py").string();
    if (!can_run({"python3", draw, "ready"}))
        throw InputError(
            {}, "measure needs matplotlib: python3-matplotlib, or what your system calls it");
    choose_reference("");
    std::vector<std::string> targets;
    double seconds = 0;
    for (const File& file : studied) {
        for (const std::string& program : file.programs) targets.push_back("measure_" + program);
        seconds += file.seconds * file.turns;
    }
    build(targets);

    {
        Meter meter(seconds);
        for (const File& file : studied)
            write_text(docs / "accuracy" / (file.name + ".csv"), measured(file, meter));
    }
    const int status = run_process({"python3", draw});
    if (status == 0) std::puts("measured: read docs/reference/accuracy.md");
    return status;
}

}  // namespace rt
