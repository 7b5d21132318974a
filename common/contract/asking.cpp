#include "common/contract/asking.hpp"
#include "common/contract/frame.hpp"
#include "common/stages/reasons.hpp"
#include "common/system/countdown.hpp"
#include "common/system/descriptors.hpp"
#include "common/system/text.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <string_view>
#include <vector>

extern char** environ;

namespace rt::contract {

namespace {

constexpr std::chrono::milliseconds between_looks{20};
constexpr double longest_look = std::chrono::duration<double>(Countdown::longest_look).count();
constexpr double ending_seconds = 0.2;  // it has closed its end: the rest of its end takes less

std::string seconds_text(double seconds) {
    std::string text = std::to_string(seconds);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text;
}

/// Untrusted text, made safe for one line.
std::string plain(std::string words) {
    if (words.size() > longest_words) words.resize(longest_words);
    for (char& c : words)
        if (static_cast<unsigned char>(c) < ' ' || c == 127) c = '?';
    return words;
}

/// The program, or, for untrusted code, the launcher that becomes it, sealed.
std::vector<std::string> command_of(const std::string& program) {
    const char* sealed = std::getenv("RAYSTEPS_SEALED");
    if (sealed == nullptr) return {program};
    std::vector<std::string> command{sealed};
    if (const char* limits = std::getenv("RAYSTEPS_LIMITS"))
        std::ranges::copy(words_of(limits), std::back_inserter(command));
    command.insert(command.end(), {"--", program});
    return command;
}

/// The cause of the end, as a clause.
std::string words_of_signal(int signal) {
    if (signal == SIGSYS)
        return std::string(forbidden_operation) + ": files, processes and networks are closed";
    if (signal == SIGXCPU) return "took more computing time than allowed";
    return "crashed: " + std::string(strsignal(signal));
}

/// True if the process is neither computing nor about to: it waits for its own reasons.
bool is_asleep(pid_t process) {
    std::array<char, 512> text{};
    const int file =
        open(("/proc/" + std::to_string(process) + "/stat").c_str(), O_RDONLY | O_CLOEXEC);
    if (file == -1) return true;
    const ssize_t size = read(file, text.data(), text.size());
    close(file);
    const std::string_view stat(text.data(), std::size_t(std::max<ssize_t>(size, 0)));
    const std::size_t name_end = stat.rfind(") ");  // the name may contain any character
    if (name_end == std::string_view::npos || name_end + 2 >= stat.size()) return true;
    return stat[name_end + 2] != 'R';
}

}  // namespace

Stopwatch::Stopwatch(pid_t process) : process_(process) {
#ifdef __linux__
    clockid_t clock{};
    if (clock_getcpuclockid(process, &clock) == 0) clock_ = clock;
#endif
}

double Stopwatch::computed() {
    timespec time{};
    if (clock_ && clock_gettime(*clock_, &time) == 0)
        computed_ = double(time.tv_sec) + double(time.tv_nsec) * 1e-9;
    return computed_;
}

double Stopwatch::waits() {
    computed_when_looked_ = computed();
    looked_ = Clock::now();
    return computed_ + slept_;
}

bool Stopwatch::is_due() const {
    return Clock::now() - looked_ >= between_looks;
}

void Stopwatch::look() {
    const double passed = std::chrono::duration<double>(Clock::now() - looked_).count();
    const double worked = computed() - computed_when_looked_;
    if (is_asleep(process_)) slept_ += std::clamp(passed - worked, 0.0, longest_look);
    waits();
}

Worker::Worker(const std::string& program) : tickets_(std::random_device{}()) {
    int sockets[2];
    std::unique_lock lock(inheritance);
    if (socketpair(AF_UNIX, SOCK_STREAM, 0, sockets) != 0)
        throw CannotStart("no socket: " + std::string(std::strerror(errno)));
    for (const int end : sockets) prepare_socket(end);
    socket_ = sockets[0];
    // A call waits for the worker for this long, then the stopwatch is due.
    const timeval between{.tv_sec = 0, .tv_usec = std::chrono::microseconds(between_looks).count()};
    for (const int wait : {SO_RCVTIMEO, SO_SNDTIMEO})
        setsockopt(socket_, SOL_SOCKET, wait, &between, sizeof between);
    // Its output is discarded: it may print for every query.
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", O_WRONLY, 0);
    const std::vector<std::string> command = command_of(program);
    const bool sealed = command.size() > 1;  // then only the launcher's complaints get out
    if (!sealed) posix_spawn_file_actions_adddup2(&actions, 1, 2);
    posix_spawn_file_actions_adddup2(&actions, sockets[1], worker_descriptor);
    std::vector<char*> arguments;
    for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    const int error =
        posix_spawn(&process_, arguments[0], &actions, nullptr, arguments.data(), environ);
    lock.unlock();
    posix_spawn_file_actions_destroy(&actions);
    close(sockets[1]);
    if (error != 0) {
        process_ = 0;
        close(socket_);
        throw CannotStart(command[0] + " cannot be started: " + std::strerror(error));
    }
    stopwatch_ = Stopwatch(process_);
}

Worker::~Worker() {
    end();
}

int Worker::end() {
    if (process_ <= 0) return 0;
    (void)stopwatch_.computed();  // while it can be read
    kill(process_, SIGKILL);
    int status = 0;
    while (waitpid(process_, &status, 0) == -1 && errno == EINTR) continue;
    process_ = 0;
    close(socket_);
    return status;
}

void Worker::give_up(const std::string& reason) {
    end();
    throw NoAnswer(reason);
}

/// The worker has closed its end. The signal that ended it is available shortly after, or the
/// worker ended by itself.
void Worker::it_has_ended() {
    int status = 0;
    const double start = stopwatch_.used();
    for (;;) {
        if (waitpid(process_, &status, WNOHANG) == process_) {
            process_ = 0;
            close(socket_);
            if (WIFSIGNALED(status)) throw NoAnswer(words_of_signal(WTERMSIG(status)));
            throw NoAnswer("ended the program, with status " + std::to_string(WEXITSTATUS(status)));
        }
        if (stopwatch_.used() - start > ending_seconds) give_up("closed the channel to the grader");
        usleep(1000);
        stopwatch_.look();
    }
}

template <class Call>
std::size_t Worker::transfer(Call call, Allowance allowance) {
    for (;;) {
        const bool is_due = stopwatch_.is_due();
        const ssize_t count = call(is_due ? MSG_DONTWAIT : 0);
        const bool in_vain = count < 0 && (errno == EAGAIN || errno == EINTR);
        if (count <= 0 && !in_vain) it_has_ended();
        if (is_due && in_vain) stopwatch_.look();  // it may sleep after its answer
        if (is_due && stopwatch_.used() >= allowance.until)
            give_up("gave no answer within " + seconds_text(allowance.seconds) + " s");
        if (!in_vain) return std::size_t(count);
    }
}

void Worker::send(std::string_view bytes, Allowance allowance) {
    while (!bytes.empty())
        bytes.remove_prefix(transfer(
            [&](int flags) {
                return ::send(socket_, bytes.data(), bytes.size(), flags | send_without_signal);
            },
            allowance));
}

std::size_t Worker::receive(char* to, std::size_t most, Allowance allowance) {
    return transfer([&](int flags) { return recv(socket_, to, most, flags); }, allowance);
}

std::string Worker::ask(const std::string& question, double seconds, double most) {
    if (!alive()) throw NoAnswer("has already ended");
    const double used = stopwatch_.waits();
    if (used >= most) give_up("took too long");
    const Allowance allowance{.seconds = seconds, .until = std::min(used + seconds, most)};
    const Frame asked{.size = question.size(), .ticket = tickets_()};
    std::string frame(reinterpret_cast<const char*>(&asked), sizeof asked);
    frame += question;
    send(frame, allowance);

    // Most answers are one piece.
    std::array<char, 4096> piece;
    std::size_t count = 0;
    while (count < sizeof(Frame))
        count += receive(piece.data() + count, piece.size() - count, allowance);
    Frame got{};
    std::memcpy(&got, piece.data(), sizeof got);
    count -= sizeof got;
    if (got.ticket != asked.ticket || got.size < 1 || count > got.size)
        give_up("wrote into the channel to the grader");
    if (got.size > largest_answer) give_up("gave an answer that is larger than any answer is");
    std::string answer(got.size, '\0');
    std::memcpy(answer.data(), piece.data() + sizeof got, count);
    while (count < answer.size())
        count += receive(answer.data() + count, answer.size() - count, allowance);
    const auto outcome = static_cast<Outcome>(answer.front());
    answer.erase(0, 1);
    if (outcome == Outcome::answered) return answer;
    throw NoAnswer("threw an exception: " + plain(answer));
}

}  // namespace rt::contract
