#include "tests/kit/seed.hpp"

#include "tests/kit/catch.hpp"

#include "common/system/hash.hpp"

#include <charconv>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <string>

namespace rt {

namespace {

constexpr std::uint64_t default_seed = 2021;

Seed read_seed() {
    const char* const file = std::getenv("RAYSTEPS_SEED_FILE");
    if (file != nullptr && std::getenv("RAYSTEPS_AS_WRITTEN") == nullptr) {
        Seed seed{.secret = true};
        if (!(std::ifstream(file) >> std::hex >> seed.number))
            throw std::runtime_error("the file that RAYSTEPS_SEED_FILE names has no seed");
        return seed;
    }
    const char* said = std::getenv("RAYSTEPS_SEED");
    if (said == nullptr) return {.number = default_seed};
    const std::string_view digits = said;
    Seed seed;
    const auto [end, error] =
        std::from_chars(digits.data(), digits.data() + digits.size(), seed.number);
    if (error != std::errc() || end != digits.data() + digits.size())
        throw std::runtime_error("RAYSTEPS_SEED must be a number, not " + std::string(digits));
    return seed;
}

}  // namespace

const Seed& seed() {
    static const Seed seed = read_seed();
    return seed;
}

std::uint64_t draw_number(std::uint64_t seed, std::string_view name, std::uint64_t i) {
    return keyed_hash({seed, i}, name);
}

std::uint64_t draw_number(std::uint64_t i) {
    return draw_number(seed().number, Catch::getResultCapture().getCurrentTestName(), i);
}

}  // namespace rt
