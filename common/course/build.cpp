#include "common/course/build.hpp"

#include "common/course/process.hpp"
#include "common/input_error.hpp"
#include "common/terminal.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

namespace rt {

namespace {

/// A word as a shell takes it literally.
std::string quoted(const std::string& word) {
    std::string text = "'";
    for (const char c : word) text += c == '\'' ? "'\\''" : std::string(1, c);
    return text + "'";
}

/// What ninja says, line by line.
class Listener {
public:
    void hear(const std::string& line) {
        int done = 0;
        int total = 0;
        double seconds = 0;
        if (std::sscanf(line.c_str(), "[%d %d %lf]", &done, &total, &seconds) == 3) {
            if (shown_ && done > 0)
                std::fprintf(stderr, "\rbuilding: %3d %%, %.0f s left\033[K", 100 * done / total,
                             seconds * (total - done) / done);
            in_failure_ = false;
        } else if (line.rfind("FAILED: ", 0) == 0) {
            failures_.emplace_back();
            in_failure_ = skip_ = true;
        } else if (skip_) {  // the command, which is long, and not what is wrong
            skip_ = false;
        } else if (line.rfind("ninja: ", 0) != 0 || line.rfind("ninja: error: ", 0) == 0) {
            (in_failure_ ? failures_.back() : rest_) += line;
        }
    }

    void end(bool failed) {
        if (shown_) std::fputs("\r\033[K", stderr);
        if (!failed) return;
        // What fails in one precision fails in the other with the same words.
        std::sort(failures_.begin(), failures_.end());
        failures_.erase(std::unique(failures_.begin(), failures_.end()), failures_.end());
        for (const std::string& failure : failures_) std::fputs(failure.c_str(), stderr);
        if (failures_.empty()) std::fputs(rest_.c_str(), stderr);
    }

private:
    bool shown_ = errors_on_terminal();
    bool in_failure_ = false;
    bool skip_ = false;
    std::vector<std::string> failures_;
    std::string rest_;
};

/// A line of any length with its end; nothing at the end of the file.
std::string read_line(std::FILE* file) {
    std::string line;
    std::array<char, 4096> buffer{};
    while (std::fgets(buffer.data(), buffer.size(), file) != nullptr) {
        line += buffer.data();
        if (line.back() == '\n') break;
    }
    return line;
}

}  // namespace

int build(const std::string& folder, const std::vector<std::string>& targets) {
    std::string command = "NINJA_STATUS='[%f %t %e] ' ninja -C " + quoted(folder);
    for (const std::string& target : targets) command += " " + quoted(target);
    std::FILE* const pipe = popen((command + " 2>&1").c_str(), "r");
    if (pipe == nullptr) throw InputError({}, "cannot start ninja");
    Listener listener;
    for (std::string line = read_line(pipe); !line.empty(); line = read_line(pipe))
        listener.hear(line);
    const int status = exit_status(pclose(pipe));
    listener.end(status != 0);
    return status;
}

}  // namespace rt
