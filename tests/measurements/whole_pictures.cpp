// Raysteps against POV-Ray 3.7 and Tachyon on whole pictures: CPU time of the tracing alone.
//
//     make_peer_scenes FOLDER
//     whole_pictures FOLDER [ROUNDS [SCENE...]]
//
// The three run in turn, so that other load on the machine affects all alike: read the ratios. A
// peer's tracing time is its CPU time minus that of the same scene at 16 × 12, which contains all
// of the reading and building; its picture is discarded. Raysteps' is measured inside the program.
//
// Instruction counts do not show pipeline stalls; a sampling profiler does (perf record -e
// cpu-clock, then perf annotate). A load of a number that was stored in two parts waits a dozen
// cycles for both stores: two ints of a Pixel that a std::function took by reference, three bytes
// of a color. These, a hit that `rep stos` zeroed before it was filled, and a tangent that was
// computed for every pixel took over a quarter of the time of the three spheres.
//
// Tried without success: link-time optimization of the parts (6 to 9 % of the three spheres,
// nothing else, and 12 s for each link), -fno-trapping-math, one division in place of three in unit
// (1.5 %), an eye direction for shining surfaces only (1.6 %), bounding spheres in the leaves of a
// hierarchy, a first test of spheres without a division.
#include "common/program/load_meshes.hpp"
#include "common/render/render.hpp"
#include "common/scene_file/reader.hpp"
#include "common/system/countdown.hpp"
#include "common/system/process.hpp"

#include "steps/step02_camera_basis/camera_basis.hpp"

#include "tests/measurements/peer_scenes.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace measurements;
using Seconds = std::vector<double>;

constexpr rt::Resolution tiny{.width = 16, .height = 12};
constexpr double povray_bar = 0.4;  // the largest accepted ratio to POV-Ray's time
constexpr double mean_povray_bar = 0.3;
constexpr double thread_bar = 1.8;  // one thread's time over two threads', at least
constexpr double no_bar = 1e300;

/// A picture and its costs, round by round. Tachyon's are empty if it cannot render the scene.
struct Picture {
    PeerScene scene;
    std::string stem;  ///< of its files
    Seconds ours;
    Seconds ours_setup;
    Seconds ours_wall;
    Seconds two_threads;
    Seconds two_threads_wall;
    Seconds povray;
    Seconds povray_setup;
    Seconds tachyon;
    Seconds tachyon_setup;
};

/// The CPU seconds of a program.
double cost_of(const rt::Command& command) {
    const rt::ProcessResult result = rt::run_captured(command, std::chrono::hours(1));
    if (result.status != 0) throw std::runtime_error(command.front() + " failed");
    return result.processor_seconds;
}

/// Seconds of this process, so far: of all its threads, and of the clock.
struct Usage {
    double cpu = rt::cpu_seconds();
    double wall =
        std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
};

/// Calls the work in a separate process, so that it starts with nothing built and nothing cached,
/// and returns the cost of each step: a step ends when the work calls its argument.
std::vector<Usage> run_apart(
    const std::function<void(const std::function<void()>& step_done)>& work) {
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0) throw std::runtime_error("cannot create a pipe");
    std::fflush(nullptr);  // otherwise the child would print the buffered output again
    const pid_t child = fork();
    if (child == 0) {
        try {
            Usage before;
            work([&] {
                const Usage now;
                const Usage step{.cpu = now.cpu - before.cpu, .wall = now.wall - before.wall};
                if (write(ends[1], &step, sizeof step) != sizeof step) _exit(1);
                before = now;
            });
        } catch (const std::exception& error) {
            std::fprintf(stderr, "%s\n", error.what());
            _exit(1);
        }
        _exit(0);
    }
    close(ends[1]);
    std::vector<Usage> steps;
    for (Usage step; read(ends[0], &step, sizeof step) == sizeof step;) steps.push_back(step);
    close(ends[0]);
    int status = -1;
    if (waitpid(child, &status, 0) != child || status != 0)
        throw std::runtime_error("the separate process failed");
    return steps;
}

double povray(const Picture& picture, rt::Resolution size) {
    return cost_of({"povray", "-D", "-V", "-F", "+WT1", "+I" + picture.stem + ".pov",
                    "+W" + std::to_string(size.width), "+H" + std::to_string(size.height)});
}

double tachyon(const Picture& picture, rt::Resolution size) {
    return cost_of({"tachyon", picture.stem + ".dat", "-res", std::to_string(size.width),
                    std::to_string(size.height), "-numthreads", "1", "-shade_phong", "-format",
                    "PPM", "-o", "/dev/null"});
}

/// Two steps: reading and building, then tracing.
std::vector<Usage> ours(const Picture& picture, int threads) {
    return run_apart([&](const auto& step_done) {
        rt::Scene scene = rt::load_scene(picture.stem + ".rt", rt::orthonormal_basis);
        rt::load_meshes(scene);
        rt::build_acceleration(scene);
        step_done();
        const auto& [depth, shadow_samples] = picture.scene.effort;
        const auto rendering = rt::render(
            scene,
            {.threads = threads, .settings = {.shadow_samples = shadow_samples, .depth = depth}});
        step_done();
    });
}

void run_round(Picture& picture) {
    const rt::Resolution size = picture.scene.size;
    const bool for_tachyon = std::filesystem::exists(picture.stem + ".dat");
    picture.povray.push_back(povray(picture, size));
    const std::vector<Usage> one = ours(picture, 1);
    picture.ours_setup.push_back(one.at(0).cpu);
    picture.ours.push_back(one.at(1).cpu);
    picture.ours_wall.push_back(one.at(1).wall);
    const Usage two = ours(picture, 2).at(1);
    picture.two_threads.push_back(two.cpu);
    picture.two_threads_wall.push_back(two.wall);
    if (for_tachyon) picture.tachyon.push_back(tachyon(picture, size));
    picture.povray_setup.push_back(povray(picture, tiny));
    if (for_tachyon) picture.tachyon_setup.push_back(tachyon(picture, tiny));
}

double best(Seconds seconds) {
    std::sort(seconds.begin(), seconds.end());
    return seconds.front();
}

double median(Seconds seconds) {
    std::sort(seconds.begin(), seconds.end());
    return seconds[seconds.size() / 2];
}

Seconds less(Seconds whole, const Seconds& setup) {
    for (double& seconds : whole) seconds = std::max(seconds - median(setup), 1e-3);
    return whole;
}

/// Best over best and median over median, with a star where it is above the bar.
void print_ratio(const Seconds& ours, const Seconds& theirs, double bar) {
    const double of_best = best(ours) / best(theirs);
    const double of_median = median(ours) / median(theirs);
    std::printf("  %5.2f%s %5.2f%s", of_best, of_best > bar ? "*" : " ", of_median,
                of_median > bar ? "*" : " ");
}

void print_tracing(const std::vector<Picture>& pictures) {
    std::printf("\nCPU time of the tracing, one thread: best | median; * is above the bar\n");
    std::printf("%-32s %9s  %-14s %-14s %-14s\n", "", "POV-Ray s", " ours/POV-Ray", " Tachyon/POV",
                " ours/Tachyon");
    double logarithms = 0;
    for (const Picture& picture : pictures) {
        const Seconds povray = less(picture.povray, picture.povray_setup);
        logarithms += std::log(best(picture.ours) / best(povray));
        std::printf("%-32s %9.2f", picture.scene.what.c_str(), best(povray));
        print_ratio(picture.ours, povray, povray_bar);
        if (!picture.tachyon.empty()) {
            const Seconds tachyon = less(picture.tachyon, picture.tachyon_setup);
            print_ratio(tachyon, povray, no_bar);
            print_ratio(picture.ours, tachyon, picture.scene.tachyon_bar);
        }
        std::printf("\n");
    }
    const double mean = std::exp(logarithms / double(pictures.size()));
    std::printf("%-42s  %5.2f%s\n", "geometric mean", mean, mean > mean_povray_bar ? "*" : "");
}

void print_setups(const std::vector<Picture>& pictures) {
    std::printf("\nCPU seconds of reading and building, best: ours, POV-Ray, Tachyon\n");
    for (const Picture& picture : pictures) {
        std::printf("%-32s %9.3f %9.3f", picture.scene.what.c_str(), best(picture.ours_setup),
                    best(picture.povray_setup));
        if (!picture.tachyon_setup.empty()) std::printf(" %9.3f", best(picture.tachyon_setup));
        std::printf("\n");
    }
}

/// Two threads finish in half the time only if both processors are free. Their total cost shows
/// contention on a busy machine too.
void print_threads(const std::vector<Picture>& pictures) {
    std::printf("\nOurs, one thread's time over two threads': wall, best | median; * is below\n");
    std::printf("%-42s  %-14s %s\n", "", "", "CPU time, two threads' over one's, best");
    for (const Picture& picture : pictures) {
        std::printf("%-42s", picture.scene.what.c_str());
        for (double (*const of)(Seconds) : {best, median}) {
            const double gain = of(picture.ours_wall) / of(picture.two_threads_wall);
            std::printf("  %5.2f%s", gain, gain < thread_bar ? "*" : " ");
        }
        std::printf("  %5.2f\n", best(picture.two_threads) / best(picture.ours));
    }
}

}  // namespace

int main(int count, char** words) {
    try {
        const std::vector<std::string> arguments(words, words + count);
        if (count < 2)
            throw std::runtime_error("expected whole_pictures FOLDER [ROUNDS [SCENE...]]");
        const int rounds = count > 2 ? std::max(std::atoi(words[2]), 1) : 5;
        std::vector<Picture> pictures;
        for (const PeerScene& scene : peer_scenes())
            if (count <= 3 ||
                std::find(arguments.begin() + 3, arguments.end(), scene.name) != arguments.end())
                pictures.push_back({.scene = scene, .stem = arguments[1] + "/" + scene.name});
        for (Picture& picture : pictures) {
            if (!std::filesystem::exists(picture.stem + ".pov"))
                throw std::runtime_error(picture.stem +
                                         ".pov is missing: make_peer_scenes makes it");
            std::fprintf(stderr, "%s\n", picture.scene.what.c_str());
            for (int round = 0; round < rounds; ++round) run_round(picture);
        }
        print_tracing(pictures);
        print_threads(pictures);
        print_setups(pictures);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
}
