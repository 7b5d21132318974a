// call_once WORKER QUESTION
//
// Calls one function of a worker, for a figure of the book. The question is in hexadecimal digits,
// as the answer that is printed. Exit status 1 if there is none, with the reason; 2 if the program
// or the question is not one.
#include "common/contract/asking.hpp"

#include <charconv>
#include <cstdio>
#include <stdexcept>
#include <string>

namespace rt::contract {

namespace {

constexpr double time_limit = 2;  // seconds

std::string bytes_of(const std::string& digits) {
    std::string bytes;
    for (std::size_t i = 0; i + 1 < digits.size(); i += 2) {
        unsigned byte = 0;
        const char* const first = digits.data() + i;
        if (std::from_chars(first, first + 2, byte, 16).ptr != first + 2)
            throw std::runtime_error("not hexadecimal digits: " + digits);
        bytes += char(byte);
    }
    if (bytes.empty()) throw std::runtime_error("no question");
    return bytes;
}

void print_digits(const std::string& bytes) {
    for (const char byte : bytes) std::printf("%02x", unsigned(static_cast<unsigned char>(byte)));
    std::puts("");
}

}  // namespace

}  // namespace rt::contract

int main(int argc, char** argv) {
    using namespace rt::contract;
    try {
        if (argc != 3) throw std::runtime_error("call_once WORKER QUESTION");
        const std::string question = bytes_of(argv[2]);
        Worker worker(argv[1]);
        print_digits(worker.ask(question, time_limit));
        return 0;
    } catch (const NoAnswer& reason) {
        std::printf("your code %s\n", reason.what());
        return 1;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "error: %s\n", error.what());
        return 2;
    }
}
