#include "common/course/build/build.hpp"

#include "common/course/build/compiler_errors.hpp"
#include "common/course/build/project.hpp"
#include "common/course/build/student_objects.hpp"
#include "common/system/files.hpp"
#include "common/system/input_error.hpp"
#include "common/system/process.hpp"
#include "common/system/terminal.hpp"
#include "common/system/translation.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <thread>

namespace rt {

namespace {

const std::string compiling = "Building CXX object ";

/// The file of an edge of the build: "sphere.cpp" of "Building CXX object …/sphere.cpp.o".
std::string file_of(const std::string& edge) {
    std::string file = edge.substr(edge.find_last_of("/ ") + 1);
    const std::size_t object = file.rfind(".o");
    if (object != std::string::npos && object + 2 == file.size()) file.resize(object);
    return file;
}

/// Parses the output of ninja, line by line.
class Listener {
public:
    explicit Listener(const std::function<void(const std::string&)>& done) : done_(done) {}

    /// Nothing new was printed for a while.
    void wait() { status_.show_again(); }

    void hear(const std::string& line) {
        int done = 0;
        int total = 0;
        double seconds = 0;
        int end = 0;
        if (std::sscanf(line.c_str(), "[%d %d %lf] %n", &done, &total, &seconds, &end) == 3) {
            const std::string edge =
                line.substr(std::size_t(end), line.find_last_not_of('\n') + 1 - std::size_t(end));
            show_progress(done, total, seconds, edge);
            const bool compiles = edge.starts_with(compiling) && is_student_object(edge);
            object_ = compiles ? edge.substr(compiling.size()) : "";
            if (!object_.empty()) warnings_[object_] = "";
            in_failure_ = false;
            if (done_) done_(edge);
        } else if (line.starts_with("FAILED: ")) {
            failures_.emplace_back();
            in_failure_ = skip_ = true;
            warnings_.erase(object_);
            // the long command line of a failed step, which does not help the student
        } else if (skip_) {
            skip_ = false;
        } else if (!line.starts_with("ninja: ") || line.starts_with("ninja: error: ")) {
            (in_failure_ ? failures_.back() : rest_) += line;
            if (!in_failure_ && !object_.empty()) warnings_[object_] += line;
        }
    }

    /// The errors; without errors, the rest of the output.
    std::string end() {
        for (const auto& [object, output] : warnings_) keep_warnings(build_folder / object, output);
        // A file that fails in one precision fails in the other with the same message.
        std::ranges::sort(failures_);
        failures_.erase(std::unique(failures_.begin(), failures_.end()), failures_.end());
        std::string all;
        for (const std::string& failure : failures_) all += failure;
        return failures_.empty() ? rest_ : all;
    }

private:
    /// The edges of CMake, before those of the build, are no part of it, nor is their time.
    void show_progress(int done, int total, double seconds, const std::string& edge) {
        if (done == 0 || total == 0) return;
        if (edge.starts_with("Re-running CMake") || edge.starts_with("Re-checking globbed")) {
            before_ = seconds;
            status_.show(tr("configuring …"));
            return;
        }
        const std::string left = tr_text(time_left(seconds - before_, done, total));
        const Values values = {{"percent", formatted("%3d", 100 * done / total)},
                               {"left", left},
                               {"file", file_of(edge)}};
        status_.show(tr("building: {percent} %{left}: {file}", values));
    }

    const std::function<void(const std::string&)>& done_;
    StatusLine status_{tr("building …")};
    double before_ = 0;   ///< seconds until the first edge of the build began
    std::string object_;  ///< the student's object that was compiled last
    std::map<std::string, std::string> warnings_;  ///< of each student's object
    bool in_failure_ = false;
    bool skip_ = false;
    std::vector<std::string> failures_;
    std::string rest_;
};

/// Waits for another build, such as of `watch` beside `run`: ninja's logs are made for one at a
/// time.
class BuildLock {
public:
    BuildLock()
        : file_(open((build_folder / "building").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
        if (flock(file_, LOCK_EX | LOCK_NB) == 0) return;
        StatusLine status(tr("waiting for another build …"));
        while (flock(file_, LOCK_EX | LOCK_NB) != 0) {
            status.show_again();
            std::this_thread::sleep_for(std::chrono::milliseconds(100));
        }
    }
    ~BuildLock() { close(file_); }
    BuildLock(const BuildLock&) = delete;
    BuildLock& operator=(const BuildLock&) = delete;

private:
    int file_;
};

}  // namespace

Build try_build(const std::vector<std::string>& targets,
                const std::function<void(const std::string& edge)>& done) {
    Command command = {"env", "NINJA_STATUS=[%f %t %e] ", "ninja", "-C", build_folder.string()};
    if (done) command.insert(command.end(), {"-k", "0"});
    command.insert(command.end(), targets.begin(), targets.end());
    const BuildLock lock;
    Listener listener(done);
    std::string line;  // the last one, whose end is not printed yet
    const auto began = fs::file_time_type::clock::now();
    const int status = run_heard(command, Streams::both, [&](std::string_view piece) {
        if (piece.empty()) listener.wait();
        line += piece;
        for (std::size_t end; (end = line.find('\n')) != std::string::npos; line.erase(0, end + 1))
            listener.hear(line.substr(0, end + 1));
    });
    if (!line.empty()) listener.hear(line);
    outdate_objects(began);
    return {.succeeded = status == 0, .output = listener.end()};
}

void build(const std::vector<std::string>& targets) {
    const Build built = try_build(targets);
    if (!built.succeeded) throw ProgramError(first_error(built.output));
}

void choose_reference(const std::string& stages) {
    const std::string setting = "RAYSTEPS_REFERENCE:STRING=" + stages;
    for (const std::string& line : lines_of(read_text(build_folder / "CMakeCache.txt")))
        if (line == setting) return;
    const BuildLock lock;
    const StatusLine status(tr("configuring …"));
    const ProcessResult ending =
        run_captured({"cmake", "-D" + setting, build_folder.string()}, std::chrono::minutes(5));
    if (ending.status != 0) throw ProgramError(tr("error: cmake failed") + "\n" + ending.output);
}

}  // namespace rt
