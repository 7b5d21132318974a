#include "common/course/grade/sandbox/layers.hpp"

#include "common/course/grade/sandbox/seal.hpp"

#include <fcntl.h>
#include <linux/capability.h>
#include <linux/landlock.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <utility>

namespace rt::grade {

namespace {

/// Returns the result of a trial in a separate process.
template <class Trial>
bool holds(Trial trial) {
    const pid_t process = fork();
    if (process == 0) _exit(trial() ? 0 : 1);
    int status = 1;
    while (waitpid(process, &status, 0) == -1 && errno == EINTR) continue;
    return process > 0 && status == 0;
}

bool files_are_out_of_reach() {
    const Landlock rules;
    return rules.put_on() && open("/", O_RDONLY | O_DIRECTORY) == -1 && errno == EACCES;
}

bool calls_are_filtered() {
    return filter_system_calls({.work = Work::building}) && socket(AF_UNIX, SOCK_STREAM, 0) == -1 &&
           errno == ENOSYS;
}

bool memory_is_limited() {
    constexpr int megabytes = 512;
    if (!limit({.megabytes = megabytes})) return false;
    return mmap(nullptr, std::size_t(megabytes) << 20, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS, -1,
                0) == MAP_FAILED;
}

/// A process that stays until the pipe is closed at its other end.
bool start_one_that_stays(const std::array<int, 2>& ends) {
    const pid_t process = fork();
    if (process != 0) return process > 0;
    char byte = 0;
    close(ends[1]);
    _exit(read(ends[0], &byte, 1) == 0 ? 0 : 1);
}

bool processes_are_limited() {
    constexpr int threads = 8;
    constexpr int others = 256;  // of an ordinary user, which may end meanwhile and make room
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) return false;
    if (geteuid() == 0 && !take_user_of_its_own({})) return false;
    if (!limit({.threads = threads})) return false;
    for (int i = 0; i <= threads + others; ++i)
        if (!start_one_that_stays(ends)) return true;
    return false;
}

/// The capabilities that root needs to run each process as another user, and to end it: missing in
/// a container that has "dropped" them.
std::string missing_capabilities() {
    constexpr std::array<std::pair<int, const char*>, 5> needed = {
        {{CAP_CHOWN, "CAP_CHOWN"},
         {CAP_DAC_OVERRIDE, "CAP_DAC_OVERRIDE"},
         {CAP_KILL, "CAP_KILL"},
         {CAP_SETGID, "CAP_SETGID"},
         {CAP_SETUID, "CAP_SETUID"}}};
    __user_cap_header_struct header{.version = _LINUX_CAPABILITY_VERSION_3, .pid = 0};
    std::array<__user_cap_data_struct, 2> had{};
    if (syscall(SYS_capget, &header, had.data()) != 0) return "";
    std::string missing;
    for (const auto& [number, name] : needed)
        if ((had[0].effective >> number & 1) == 0)
            missing += (missing.empty() ? ": this root lacks " : ", ") + std::string(name);
    return missing;
}

Layer layer_of_users() {
    const std::string name = "a user of its own for each process";
    if (geteuid() != 0) return {name + " (only if root grades)", false};
    const std::string missing = missing_capabilities();
    return {name + missing, missing.empty() && holds([] { return take_user_of_its_own({}); }),
            true};
}

// Newer constants of the kernel, for older headers.
struct Attributes {
    std::uint64_t files = 0;
    std::uint64_t network = 0;  ///< since version 4
    std::uint64_t scopes = 0;   ///< since version 6
};
constexpr unsigned long rights_of_version_1 = (1UL << 13) - 1;
constexpr unsigned long refer = 1UL << 13;
constexpr unsigned long truncate_file = 1UL << 14;
constexpr unsigned long command_device = 1UL << 15;
constexpr std::uint64_t all_of_network = 3;  // to bind, to connect
constexpr std::uint64_t all_scopes = 3;      // abstract sockets, signals

constexpr unsigned long of_files = LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_READ_FILE |
                                   LANDLOCK_ACCESS_FS_WRITE_FILE | truncate_file;
constexpr unsigned long reading =
    LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR;
constexpr unsigned long writing = LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR |
                                  LANDLOCK_ACCESS_FS_WRITE_FILE | truncate_file |
                                  LANDLOCK_ACCESS_FS_MAKE_REG | LANDLOCK_ACCESS_FS_MAKE_DIR |
                                  LANDLOCK_ACCESS_FS_REMOVE_FILE;  // without the right to execute

unsigned long rights_of(int version) {
    unsigned long rights = rights_of_version_1;
    if (version >= 2) rights |= refer;
    if (version >= 3) rights |= truncate_file;
    if (version >= 5) rights |= command_device;
    return rights;
}

}  // namespace

std::vector<Layer> layers() {
    const std::string version = std::to_string(Landlock::version());
    return {
        {"system calls are filtered (seccomp)", holds(calls_are_filtered), true},
        {"files are out of reach (Landlock, version " + version + ")",
         holds(files_are_out_of_reach), true},
        {"time, memory and output are limited", holds(memory_is_limited), true},
        {"processes and threads are limited", holds(processes_are_limited), true},
        layer_of_users(),
        {"namespaces of its own for each worker",
         holds([] { return take_namespaces(Work::answering); })},
        {"processes, network and mounts of its own for each compiler",
         holds([] { return take_namespaces(Work::building); })},
    };
}

bool hold(const std::vector<Layer>& layers) {
    return std::ranges::all_of(layers,
                               [](const Layer& layer) { return layer.holds || !layer.needed; });
}

int Landlock::version() {
    const long version =
        syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
    return version < 0 ? 0 : int(version);
}

Landlock::Landlock() {
    const int version = Landlock::version();
    if (version == 0) return;
    rights_ = rights_of(version);
    const Attributes attributes{.files = rights_,
                                .network = version >= 4 ? all_of_network : 0,
                                .scopes = version >= 6 ? all_scopes : 0};
    const std::size_t known = version >= 6 ? 3 : version >= 4 ? 2 : 1;
    rules_ =
        int(syscall(SYS_landlock_create_ruleset, &attributes, known * sizeof(std::uint64_t), 0));
}

Landlock::~Landlock() {
    if (rules_ != -1) close(rules_);
}

void Landlock::let_read(const std::string& path) {
    let(path, reading);
}

void Landlock::let_write(const std::string& path) {
    let(path, writing);
}

void Landlock::let_run(int program) {
    let(program, LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_READ_FILE);
}

void Landlock::let(const std::string& path, unsigned long rights) {
    const int file = open(path.c_str(), O_PATH | O_CLOEXEC);
    if (file == -1) return;
    let(file, rights);
    close(file);
}

void Landlock::let(int file, unsigned long rights) {
    struct stat about {};
    if (fstat(file, &about) != 0) return;
    if (!S_ISDIR(about.st_mode)) rights &= of_files;
    const landlock_path_beneath_attr rule{.allowed_access = rights & rights_, .parent_fd = file};
    syscall(SYS_landlock_add_rule, rules_, LANDLOCK_RULE_PATH_BENEATH, &rule, 0);
}

bool Landlock::put_on() const {
    return rules_ != -1 && prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
           syscall(SYS_landlock_restrict_self, rules_, 0) == 0;
}

}  // namespace rt::grade
