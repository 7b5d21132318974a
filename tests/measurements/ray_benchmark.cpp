// Rays per second through a packed mesh in both precisions, and in the same run through Embree.
//
//     ninja measurements && ./ray_benchmark
//
// Every engine traces every kind of ray several times, in a random order of turns, so that other
// load on the machine affects all alike. The table at the end contains medians, and ratios to
// Embree.
#include "tests/measurements/workload.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <map>

using namespace measurements;

namespace {

constexpr int repetitions = 7;

/// One engine, with measurements from outside Google Benchmark.
struct Contender {
    std::string name;
    std::unique_ptr<Engine> engine;
    double build_seconds = 0;
    std::size_t lost = 0;
};

/// A mesh, the engines that have built it, and the rays.
struct ComparisonRequest {
    TriangleMesh mesh;
    std::vector<Contender> contenders;
    std::vector<RaySet> sets;
    std::size_t rays_at_edges = 0;
};

double seconds_to_build(Engine& engine, const TriangleMesh& mesh) {
    const auto start = std::chrono::steady_clock::now();
    engine.build(mesh);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

ComparisonRequest contest_on(int frequency) {
    ComparisonRequest contest{.mesh = displaced_sphere(frequency)};
    const auto enter = [&](const char* name, std::unique_ptr<Engine> engine) {
        if (engine) contest.contenders.push_back({.name = name, .engine = std::move(engine)});
    };
    enter("Embree", embree_engine());
    enter("float", float_engine());
    enter("double", double_engine());
    for (int turn = 0; turn < 5; ++turn)
        for (Contender& contender : contest.contenders) {
            const double seconds = seconds_to_build(*contender.engine, contest.mesh);
            double& best = contender.build_seconds;
            best = turn == 0 ? seconds : std::min(best, seconds);
        }
    const std::vector<RayQuery> at_edges = rays_at_edges(contest.mesh);
    contest.rays_at_edges = at_edges.size();
    for (Contender& contender : contest.contenders)
        contender.lost =
            at_edges.size() - contender.engine->count_nearest(at_edges.data(), at_edges.size());
    contest.sets = ray_sets(contest.mesh, *contest.contenders.front().engine);
    return contest;
}

std::string name_of(const ComparisonRequest& contest, const RaySet& set,
                    const Contender& contender) {
    return std::to_string(contest.mesh.triangles.size()) + "/" + set.name + "/" + contender.name;
}

void enter(const ComparisonRequest& contest, const RaySet& set, const Contender& contender) {
    const auto take = [&set, &engine = *contender.engine](benchmark::State& state) {
        const std::vector<RayQuery>& rays = set.rays;
        for (auto turn : state)
            benchmark::DoNotOptimize(set.shadow ? engine.count_blocked(rays.data(), rays.size())
                                                : engine.count_nearest(rays.data(), rays.size()));
        state.SetItemsProcessed(state.iterations() * std::int64_t(rays.size()));
    };
    for (const int threads : {1, 2}) {
        const std::string name = name_of(contest, set, contender) + "/" + std::to_string(threads);
        benchmark::RegisterBenchmark(name.c_str(), take)
            ->Threads(threads)
            ->Iterations(1)
            ->Repetitions(repetitions);
    }
}

/// Collects the result of each turn, and writes nothing.
class Results : public benchmark::BenchmarkReporter {
public:
    bool ReportContext(const Context& /*context*/) override { return true; }

    void ReportRuns(const std::vector<Run>& runs) override {
        for (const Run& run : runs)
            if (run.run_type == Run::RT_Iteration)
                // Per second of processor time, which is independent of other processes.
                rates_[run.run_name.function_name].push_back(
                    double(run.threads) * run.counters.at("items_per_second").value);
    }

    /// The median, in rays a second; 0 if there was no turn.
    [[nodiscard]] double rate(const std::string& name) const {
        const auto found = rates_.find(name);
        if (found == rates_.end()) return 0;
        std::vector<double> rates = found->second;
        std::ranges::sort(rates);
        return rates[rates.size() / 2];
    }

private:
    std::map<std::string, std::vector<double>> rates_;
};

void print(const ComparisonRequest& contest, const Results& results) {
    const Contender& first = contest.contenders.front();
    std::printf("\n%zu triangles: million rays a second (ratio to %s)\n%-10s",
                contest.mesh.triangles.size(), first.name.c_str(), "");
    for (const RaySet& set : contest.sets)
        for (const char* threads : {"1", "2"}) std::printf(" %11s x%s", set.name.c_str(), threads);
    std::printf(" %9s  lost of %zu\n", "build s", contest.rays_at_edges);
    for (const Contender& contender : contest.contenders) {
        std::printf("%-10s", contender.name.c_str());
        for (const RaySet& set : contest.sets)
            for (const char* threads : {"/1", "/2"}) {
                const double rate = results.rate(name_of(contest, set, contender) + threads);
                const double of_first = results.rate(name_of(contest, set, first) + threads);
                std::printf(" %7.2f (%4.2f)", rate / 1e6, of_first > 0 ? rate / of_first : 0);
            }
        std::printf(" %9.3f  %zu\n", contender.build_seconds, contender.lost);
    }
}

}  // namespace

int main(int argc, char** argv) {
    std::vector<char*> arguments(argv, argv + argc);
    std::string in_turn = "--benchmark_enable_random_interleaving=true";
    arguments.insert(arguments.begin() + 1, in_turn.data());
    int count = int(arguments.size());
    benchmark::Initialize(&count, arguments.data());
    if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 2;

    std::vector<ComparisonRequest> contests;
    for (const int frequency : {59, 224}) contests.push_back(contest_on(frequency));
    for (const ComparisonRequest& contest : contests)
        for (const RaySet& set : contest.sets)
            for (const Contender& contender : contest.contenders) enter(contest, set, contender);
    Results results;
    benchmark::RunSpecifiedBenchmarks(&results);
    for (const ComparisonRequest& contest : contests) print(contest, results);
}
