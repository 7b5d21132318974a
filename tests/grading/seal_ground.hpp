// Attacks on the sandbox, each in a separate process: by the user of the test, and, if that is
// root, by an ordinary user too.
#pragma once

#include "common/system/files.hpp"
#include "common/system/process.hpp"

#include <unistd.h>

#include <csignal>
#include <filesystem>
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
    Ground();

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

[[nodiscard]] bool is_ordinary(const Who& who);

[[nodiscard]] std::vector<Who> everybody(const Ground& ground);

/// The result of an attack in the sandbox, with these limits.
[[nodiscard]] ProcessResult run(const Ground& ground, const Who& who, const Words& limits,
                                const Words& attack);
[[nodiscard]] int status(const Ground& ground, const Who& who, const Words& limits,
                         const Words& attack);
[[nodiscard]] Command sealed(const Ground& ground, const Who& who, const Words& limits,
                             const Words& attack);

/// The number of processes of a program.
[[nodiscard]] int processes_of(const fs::path& program);

}  // namespace rt
