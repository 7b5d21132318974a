#include "common/course/build.hpp"

#include "common/course/process.hpp"
#include "common/input_error.hpp"
#include "common/terminal.hpp"

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

bool starts_with(const std::string& line, const char* start) {
    return line.rfind(start, 0) == 0;
}

}  // namespace

int build(const std::string& folder, const std::vector<std::string>& targets) {
    std::string command = "NINJA_STATUS='[%p, %e s] ' ninja -C " + quoted(folder);
    for (const std::string& target : targets) command += " " + quoted(target);
    std::FILE* const pipe = popen((command + " 2>&1").c_str(), "r");
    if (pipe == nullptr) throw InputError({}, "cannot start ninja");
    const bool shown = errors_on_terminal();
    std::string said;
    std::array<char, 4096> buffer{};
    while (std::fgets(buffer.data(), buffer.size(), pipe) != nullptr) {
        const std::string line = buffer.data();
        const bool progress = starts_with(line, "[");
        if (progress && shown)
            std::fprintf(stderr, "\rbuilding: %s\033[K",
                         line.substr(0, line.find(']') + 1).c_str());
        if (!progress && !starts_with(line, "ninja: ")) said += line;
    }
    const int status = exit_status(pclose(pipe));
    if (shown) std::fputs("\r\033[K", stderr);
    if (status != 0) std::fputs(said.c_str(), stderr);
    return status;
}

}  // namespace rt
