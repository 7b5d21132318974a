// sealed [work=building] [cpu=10] [wall=30] [memory=1024] [file=0] [threads=64] [read=FOLDER]…
//        [write=FOLDER]… [input=FILE] -- PROGRAM ARGUMENTS…
//
// Becomes the program, sealed.
#include "common/course/grade/sandbox/seal.hpp"

#include <unistd.h>

#include <charconv>
#include <csignal>
#include <cstdio>

namespace {

using rt::grade::Sandbox;
using rt::grade::SealError;

int number(const std::string& text) {
    int value = 0;
    const char* end = text.data() + text.size();
    if (std::from_chars(text.data(), end, value).ptr != end || text.empty() || value < 0)
        throw SealError("not a number: " + text);
    return value;
}

void read_word(const std::string& word, Sandbox& seal) {
    const std::size_t equals = word.find('=');
    if (equals == std::string::npos) throw SealError("not of the form name=value: " + word);
    const std::string name = word.substr(0, equals);
    const std::string value = word.substr(equals + 1);
    if (name == "work" && value == "building")
        seal.work = rt::grade::Work::building;
    else if (name == "work" && value == "answering")
        seal.work = rt::grade::Work::answering;
    else if (name == "cpu")
        seal.cpu_seconds = number(value);
    else if (name == "wall")
        seal.wall_seconds = number(value);
    else if (name == "memory")
        seal.megabytes = number(value);
    else if (name == "file")
        seal.file_megabytes = number(value);
    else if (name == "threads")
        seal.threads = number(value);
    else if (name == "read")
        seal.readable.push_back(value);
    else if (name == "write")
        seal.writable.push_back(value);
    else if (name == "input")
        seal.input = value;
    else
        throw SealError("no such limit: " + word);
}

}  // namespace

int main(int count, char** words) {
    int next = 1;
    Sandbox seal;
    try {
        for (; next < count && std::string(words[next]) != "--"; ++next)
            read_word(words[next], seal);
        if (next + 1 >= count) throw SealError("sealed LIMITS -- PROGRAM ARGUMENTS");
        become(seal, {words + next + 1, words + count});
    } catch (const std::exception& error) {
        std::signal(SIGXFSZ, SIG_IGN);  // the limits may be in force already
        const std::string line = std::string("error: not sealed: ") + error.what() + "\n";
        if (write(rt::grade::complaints, line.data(), line.size()) < 0)
            std::fputs(line.c_str(), stderr);
        return rt::grade::not_sealed;
    }
}
