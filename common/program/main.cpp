// The main function of every stage's program.
#include "common/image/png.hpp"
#include "common/program/options.hpp"
#include "common/program/renderer.hpp"
#include "common/program/used_options.hpp"
#include "common/system/escaping.hpp"
#include "common/system/input_error.hpp"
#include "common/system/terminal.hpp"
#include "common/system/text.hpp"
#include "common/system/translation.hpp"
#include "common/tuning/auto_settings.hpp"
#include "common/tuning/wording.hpp"

#include <atomic>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <memory>
#include <new>
#include <string>
#include <vector>

namespace {

constexpr int bad_input = 2;
constexpr int signalled = 128;  // the convention of shells: the status is this and the signal

std::atomic<bool> stop = false;
std::atomic<int> stopped_by = 0;
std::atomic<bool> reading = false;
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free,
              "a signal handler sets them");

/// While the scene is read, the program exits at once: it has nothing to clean up, and may be in
/// the middle of ten million triangles.
void on_stop(int signal) {
    if (reading) std::_Exit(signalled + signal);
    stopped_by = signal;
    stop = true;
}

/// So that a signal leaves no unfinished file.
void catch_signals() {
    std::signal(SIGINT, on_stop);
    std::signal(SIGTERM, on_stop);
#ifdef SIGHUP
    if (std::signal(SIGHUP, on_stop) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);  // by nohup
#endif
#ifdef SIGXFSZ
    std::signal(SIGXFSZ, SIG_IGN);  // a file size limit is then an error that the program reports
#endif
}

/// The time in which a scene is read, which an error ends, too.
struct Reading {
    Reading() { reading = true; }
    ~Reading() { reading = false; }
    Reading(const Reading&) = delete;
    Reading& operator=(const Reading&) = delete;
};

#ifdef RT_EXACT
constexpr bool exact = true;
constexpr auto open_float = rt::f64::make_renderer;  // never called: the precision is fixed
#else
constexpr bool exact = false;
constexpr auto open_float = rt::f32::make_renderer;
#endif

/// Checks the output file before rendering, so that no finished picture is lost.
void check_output(const rt::Options& options) {
    std::error_code not_there;
    if (std::filesystem::equivalent(options.scene, options.output, not_there))
        throw rt::InputError({options.output},
                             "is the scene itself, which the picture would overwrite");
    rt::check_writable(options.output);
    if (rt::lower_case(std::filesystem::path(options.output).extension().string()) != ".png")
        throw rt::InputError(
            {options.output},
            "is not the name of a picture, which is a PNG file: it must end in .png");
}

std::unique_ptr<rt::Renderer> open(const rt::Program& program, const rt::Options& options,
                                   rt::Precision precision) {
    const auto make_renderer =
        precision == rt::Precision::f32 ? open_float : rt::f64::make_renderer;
    const Reading while_reading;
    return make_renderer(program, options);
}

/// Renders with automatic settings, for a tolerance or a time.
bool choose_and_run(const rt::Program& program, rt::Options options, rt::Clock::time_point start,
                    std::unique_ptr<rt::Renderer> session) {
    std::unique_ptr<rt::Renderer> in_float;
    rt::OpenFloat other;
    if (!options.precision_given && !exact)
        other = [&]() -> rt::Trials& {
            return *(in_float = open(program, options, rt::Precision::f32));
        };
    const bool shown = !options.quiet && rt::errors_on_terminal();
    if (shown) std::cerr << rt::tr("trying settings") << '\r' << std::flush;
    const auto chosen = choose(*session, other, options, start, stop);
    if (shown) std::cerr << "\033[K" << std::flush;
    if (!chosen) return false;
    options.settings = chosen->expected.settings;
    if (chosen->in_float) {
        options.precision = rt::Precision::f32;
        session = std::move(in_float);
    }
    in_float.reset();
    if (!options.quiet) {
        for (const std::string& reason : chosen->reasons) std::cout << reason << '\n';
        if (!options.time)
            std::cout << rt::one_line(
                             rt::line("equivalent", rt::equivalent_options(program, options)))
                      << '\n';
    }
    return session->run(options, chosen->pace.get(), stop);
}

std::vector<std::string> read_risks(const rt::Options& options) {
    const Reading while_reading;
    return rt::f64::risks_in_float(options);
}

void explain_risks(const rt::Options& options) {
    const std::vector<std::string> risks = read_risks(options);
    if (!risks.empty()) std::cout << rt::tr("and is at risk with --precision float") << '\n';
    for (const std::string& risk : risks) std::cout << "  " << rt::tr_text(risk) << '\n';
}

void warn_of_risks(const rt::Options& options) {
    for (const std::string& risk : read_risks(options))
        std::cerr << rt::tr_text(to_string(rt::FileLocation{options.scene}) + "warning: " + risk +
                                 "; try --precision double")
                  << '\n';
}

int run_program(int argc, char** argv) {
    const auto start = rt::Clock::now();
    const rt::Program program{.stage = rt::stage_number, .root = RAYSTEPS_ROOT, .exact = exact};
    const auto options = rt::parse_options(program, argc, argv);
    if (!options) return 0;
    if (options->makes_picture()) check_output(*options);
    std::unique_ptr<rt::Renderer> session = open(program, *options, options->precision);
    const bool is_float = options->precision == rt::Precision::f32;
    if (is_float && !options->quiet && !options->requirements) warn_of_risks(*options);
    const bool chosen = (options->tolerance || options->time) && !options->requirements;
    const bool done = chosen ? choose_and_run(program, *options, start, std::move(session))
                             : session->run(*options, nullptr, stop);
    if (options->requirements) explain_risks(*options);
    return done ? 0 : signalled + stopped_by;
}

/// ./course names the catalogue of the reader's language.
void read_sentences() {
    if (const char* catalogue = std::getenv(rt::sentences_variable))
        rt::read_translations(catalogue);
}

}  // namespace

int main(int argc, char** argv) {
    catch_signals();
    try {
        read_sentences();
        const int status = run_program(argc, argv);
        rt::finish_output();
        return status;
    } catch (const rt::InputError& error) {
        std::cerr << rt::tr_text(error.what()) << '\n';
    } catch (const std::bad_alloc&) {
        std::cerr << rt::tr_text("error: not enough memory for this") << '\n';
    } catch (const std::exception& error) {  // system resources are exhausted
        std::cerr << rt::tr_text(std::string("error: ") + error.what()) << '\n';
    }
    return bad_input;
}
