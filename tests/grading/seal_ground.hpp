// Attacks on the sandbox, each in a separate process: by the user of the test, and, if that is
// root, by an ordinary user too.
#pragma once

#include "common/system/files.hpp"
#include "common/system/process.hpp"

#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace rt {

namespace fs = std::filesystem;

constexpr int done = 0;
constexpr int refused = 1;
constexpr int ended = 128 + SIGSYS;

using Words = std::vector<std::string>;

/// A folder that everyone may enter, with the programs in it.
struct Ground {
    Ground() {
        fs::permissions(folder, fs::perms(0755));
        fs::copy_file(RAYSTEPS_SEALED, folder / "sealed");
        fs::copy_file(RAYSTEPS_ATTACKER, folder / "attacker");
        fs::copy_file(RAYSTEPS_ATTACKER, folder / "launcher");  // not counted as an attack
        fs::create_directory(folder / "scratch");
        fs::permissions(folder / "scratch", fs::perms(0777));
        std::ofstream(folder / "secret") << "expected values";
        fs::permissions(folder / "secret", fs::perms(0666));
    }

    TemporaryFolder temporary;
    const fs::path& folder = temporary.path();
};

/// An attacking user: the grader's own, or an ordinary one; with and without namespaces in the
/// kernel.
struct Who {
    std::string name;
    Words before;
};

/// A user without other processes: the limit on processes counts all of a user's, also those of
/// another test.
inline const uid_t ordinary_user = 50000 + uid_t(getpid()) % 10000;

inline bool is_ordinary(const Who& who) {
    return geteuid() != 0 || (!who.before.empty() && who.before[0] == "setpriv");
}

inline std::vector<Who> everybody(const Ground& ground) {
    std::vector<Who> all{{"whoever runs this", {}}};
    const std::string user = std::to_string(ordinary_user);
    if (geteuid() == 0)
        all.push_back({"an ordinary user",
                       {"setpriv", "--reuid=" + user, "--regid=" + user, "--clear-groups"}});
    for (std::size_t i = 0, count = all.size(); i < count; ++i) {
        Who who = all[i];
        who.name += ", without namespaces";
        who.before.insert(who.before.end(), {ground.folder / "launcher", "--no-namespaces"});
        all.push_back(who);
    }
    return all;
}

inline Command sealed(const Ground& ground, const Who& who, const Words& limits,
                      const Words& attack) {
    Command command = who.before;
    command.push_back(ground.folder / "sealed");
    command.insert(command.end(), limits.begin(), limits.end());
    command.insert(command.end(), {"--", ground.folder / "attacker"});
    command.insert(command.end(), attack.begin(), attack.end());
    return command;
}

inline ProcessResult run(const Ground& ground, const Who& who, const Words& limits,
                         const Words& attack) {
    return run_captured(sealed(ground, who, limits, attack), std::chrono::seconds(60));
}

inline int status(const Ground& ground, const Who& who, const Words& limits, const Words& attack) {
    return run(ground, who, limits, attack).status;
}

/// The number of processes of a program.
inline int processes_of(const fs::path& program) {
    int count = 0;
    for (const auto& each : fs::directory_iterator("/proc")) {
        std::ifstream in(each.path() / "cmdline");
        std::string line;
        std::getline(in, line, '\0');
        count += line == program.string();
    }
    return count;
}

}  // namespace rt
