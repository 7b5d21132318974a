#include "tests/contract/asking.hpp"

#include "tests/contract/frame.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <vector>

extern char** environ;

namespace rt::contract {

namespace {

constexpr std::size_t longest_words = 200;

std::string seconds_text(double seconds) {
    std::string text = std::to_string(seconds);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text;
}

/// Words of somebody else's making, fit for a line.
std::string plain(std::string words) {
    if (words.size() > longest_words) words.resize(longest_words);
    for (char& c : words)
        if (static_cast<unsigned char>(c) < ' ' || c == 127) c = '?';
    return words;
}

/// The program, or, where strangers' code is graded, the launcher that becomes it, sealed.
std::vector<std::string> command_of(const std::string& program) {
    const char* sealed = std::getenv("RAYSTEPS_SEALED");
    if (sealed == nullptr) return {program};
    std::vector<std::string> command{sealed};
    if (const char* limits = std::getenv("RAYSTEPS_LIMITS")) {
        std::istringstream words(limits);
        for (std::string word; words >> word;) command.push_back(word);
    }
    command.insert(command.end(), {"--", program});
    return command;
}

/// What ended it, in half a sentence.
std::string words_of_signal(int signal) {
    if (signal == SIGSYS) return "tried what it may not: files, processes and networks are closed";
    if (signal == SIGXCPU) return "took more computing time than it may";
    return "crashed: " + std::string(strsignal(signal));
}

}  // namespace

Worker::Worker(const std::string& program) : tickets_(std::random_device{}()) {
    int sockets[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sockets) != 0)
        throw CannotStart("no socket: " + std::string(std::strerror(errno)));
    socket_ = sockets[0];
    fcntl(socket_, F_SETFL, O_NONBLOCK);
    // What it prints is nobody's: it may print as often as it is asked.
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
    posix_spawn_file_actions_destroy(&actions);
    close(sockets[1]);
    if (error != 0) {
        process_ = 0;
        close(socket_);
        throw CannotStart(command[0] + " does not start: " + std::strerror(error));
    }
}

Worker::~Worker() {
    end();
}

int Worker::end() {
    if (process_ <= 0) return 0;
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

/// It has closed its end. What it was ended by is there in a moment, or its own doing.
void Worker::it_has_ended() {
    int status = 0;
    for (int tries = 0; tries < 200; ++tries) {
        if (waitpid(process_, &status, WNOHANG) == process_) {
            process_ = 0;
            close(socket_);
            if (WIFSIGNALED(status)) throw NoAnswer(words_of_signal(WTERMSIG(status)));
            throw NoAnswer("ended the program, with status " + std::to_string(WEXITSTATUS(status)));
        }
        usleep(1000);
    }
    give_up("closed the channel to who asks");
}

void Worker::wait_until_ready(short event, Clock::time_point deadline, double seconds) {
    for (;;) {
        const auto left =
            std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
        pollfd ready{.fd = socket_, .events = event, .revents = 0};
        const int count = left <= 0 ? 0 : poll(&ready, 1, int(left) + 1);
        if (count > 0) return;
        if (count < 0 && errno == EINTR) continue;
        give_up("gave no answer within " + seconds_text(seconds) + " s");
    }
}

void Worker::send(const char* from, std::size_t count, Clock::time_point deadline, double seconds) {
    while (count > 0) {
        const ssize_t sent = ::send(socket_, from, count, MSG_NOSIGNAL);
        if (sent > 0) {
            from += sent;
            count -= std::size_t(sent);
        } else if (errno == EAGAIN) {
            wait_until_ready(POLLOUT, deadline, seconds);
        } else if (errno != EINTR) {
            it_has_ended();
        }
    }
}

void Worker::receive(char* to, std::size_t count, Clock::time_point deadline, double seconds) {
    while (count > 0) {
        const ssize_t got = recv(socket_, to, count, 0);
        if (got > 0) {
            to += got;
            count -= std::size_t(got);
        } else if (got < 0 && errno == EAGAIN) {
            wait_until_ready(POLLIN, deadline, seconds);
        } else if (got == 0 || errno != EINTR) {
            it_has_ended();
        }
    }
}

std::string Worker::ask(const std::string& question, double seconds) {
    if (!alive()) throw NoAnswer("is not there any more");
    const Clock::time_point deadline =
        Clock::now() + std::chrono::microseconds(std::int64_t(seconds * 1e6));
    const Frame asked{.size = question.size(), .ticket = tickets_()};
    std::string frame(reinterpret_cast<const char*>(&asked), sizeof asked);
    frame += question;
    send(frame.data(), frame.size(), deadline, seconds);

    wait_until_ready(POLLIN, deadline, seconds);  // to look for it first is always too early
    Frame came{};
    receive(reinterpret_cast<char*>(&came), sizeof came, deadline, seconds);
    if (came.ticket != asked.ticket || came.size < 1 || came.size > largest_frame)
        give_up("wrote into the channel to who asks");
    std::string answer(came.size, '\0');
    receive(answer.data(), answer.size(), deadline, seconds);
    const auto outcome = static_cast<Outcome>(answer.front());
    answer.erase(0, 1);
    if (outcome == Outcome::answered) return answer;
    throw NoAnswer("threw an exception: " + plain(answer));
}

}  // namespace rt::contract
