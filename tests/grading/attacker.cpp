// Tries what a sealed process may not do: `attacker WHAT [PATH]` ends with status 0 if it could.
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/ptrace.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstring>
#include <ctime>
#include <functional>
#include <map>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

extern char** environ;

namespace {

constexpr const char* program = "/bin/true";
std::string path;

bool opens(int flags) {
    return open(path.c_str(), flags, 0644) != -1;
}

bool starts_threads(int count) {
    std::vector<pthread_t> threads(static_cast<std::size_t>(count));
    pthread_attr_t small;
    pthread_attr_init(&small);
    pthread_attr_setstacksize(&small, 16384);
    for (pthread_t& thread : threads)
        if (pthread_create(
                &thread, &small, [](void*) -> void* { return sleep(60), nullptr; }, nullptr) != 0)
            return false;
    return true;
}

bool finds_an_open_descriptor() {
    char byte = 0;
    for (int each = 3; each < 1024; ++each)
        if (lseek(each, 0, SEEK_CUR) != -1 || errno != EBADF || read(each, &byte, 0) == 0)
            return true;
    return false;
}

bool finds_the_environment() {
    for (char** word = environ; *word != nullptr; ++word)
        if (std::strncmp(*word, "SECRET=", 7) == 0) return true;
    return false;
}

bool leaves_a_daemon() {
    if (fork() == 0) {
        setsid();
        if (fork() == 0) {
            sleep(1);
            opens(O_WRONLY | O_CREAT);
        }
        _exit(0);
    }
    sleep(0);
    return true;
}

[[noreturn]] void spin() {
    for (volatile int i = 0;;) i = i + 1;
}

const std::map<std::string, std::function<bool()>> attempts{
    {"nothing", [] { return true; }},
    {"read", [] { return opens(O_RDONLY); }},
    {"write", [] { return opens(O_WRONLY | O_CREAT); }},
    {"socket", [] { return socket(AF_INET, SOCK_STREAM, 0) != -1; }},
    {"fork", [] { return fork() != -1; }},
    {"exec", [] { return execl(program, program, nullptr) == 0; }},
    {"exec another way",
     [] { return syscall(SYS_execveat, AT_FDCWD, program, nullptr, environ, AT_EMPTY_PATH) == 0; }},
    {"trace", [] { return ptrace(PTRACE_ATTACH, getppid(), nullptr, nullptr) == 0; }},
    {"signal", [] { return kill(path.empty() ? getppid() : std::stoi(path), 0) == 0; }},
    {"memory",
     [] {
         return mmap(nullptr, std::size_t(2) << 30, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS, -1,
                     0) != MAP_FAILED;
     }},
    {"threads", [] { return starts_threads(4); }},
    {"many threads", [] { return starts_threads(200); }},
    {"descriptors", finds_an_open_descriptor},
    {"environment", finds_the_environment},
    {"set the clock",
     [] {
         timespec now{};
         clock_gettime(CLOCK_REALTIME, &now);
         return clock_settime(CLOCK_REALTIME, &now) == 0;
     }},
    {"print",
     [] { return write(STDOUT_FILENO, "printed", 7) == 7 && write(STDERR_FILENO, "too", 3) == 3; }},
    {"namespaces", [] { return unshare(CLONE_NEWUSER) == 0; }},
    {"root", [] { return setuid(0) == 0; }},
    {"daemon", leaves_a_daemon},
    {"abort", []() -> bool { std::abort(); }},
    {"spin", []() -> bool { spin(); }},
    {"sleep", [] { return sleep(60) == 0; }},
};

}  // namespace

int main(int count, char** words) {
    if (count > 2) path = words[2];
    constexpr int unknown = 99;
    const auto attempt = attempts.find(count > 1 ? words[1] : "");
    _exit(attempt == attempts.end() ? unknown : attempt->second() ? 0 : 1);
}
