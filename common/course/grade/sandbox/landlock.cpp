#include "common/course/grade/sandbox/landlock.hpp"

#include <fcntl.h>
#include <linux/landlock.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstdint>

namespace rt::grade {

namespace {

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
