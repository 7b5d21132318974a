#include "common/course/grade/judging/seed.hpp"

#include "common/system/files.hpp"
#include "common/system/input_error.hpp"
#include "common/system/keyed_hash.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <random>

namespace rt::grade {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t digits = 16;
constexpr std::size_t identifier_digits = 8;

std::string text_of(std::uint64_t number) {
    char text[digits + 1];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(number));
    return text;
}

std::uint64_t random_bits() {
    std::random_device device;
    return std::uint64_t(device()) << 32 | device();
}

/// Gives the written file its name, unless another one has it: by a hard link, or by a renaming
/// where the disk has none (exFAT, some network disks). False, with errno, if neither works.
bool give_name(const fs::path& part, const fs::path& file) {
    return link(part.c_str(), file.c_str()) == 0 || errno == EEXIST ||
           renameat2(AT_FDCWD, part.c_str(), AT_FDCWD, file.c_str(), RENAME_NOREPLACE) == 0 ||
           errno == EEXIST;
}

/// Writes the seed whole, or leaves the one that is there.
void store(std::uint64_t seed, const fs::path& file) {
    const std::string text = text_of(seed) + "\n";
    const fs::path part = file.parent_path() / (".seed." + text_of(random_bits()));
    const int descriptor = open(part.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
    const auto fail = [&file](int error) {
        throw InputError({file}, std::string("cannot be written: ") + std::strerror(error));
    };
    if (descriptor == -1) fail(errno);
    const bool stored = write(descriptor, text.data(), text.size()) == ssize_t(text.size()) &&
                        fsync(descriptor) == 0 && give_name(part, file);
    const int error = errno;
    close(descriptor);
    unlink(part.c_str());
    if (!stored) fail(error);
}

}  // namespace

fs::path seed_file(const fs::path& results) {
    return results / "seed.txt";
}

std::uint64_t read_seed(const fs::path& file) {
    std::string text = read_text(file);
    std::erase_if(text, [](unsigned char c) { return std::isspace(c) != 0; });
    std::uint64_t seed = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, seed, 16);
    if (text.size() != digits || error != std::errc() || stop != end)
        throw InputError({file, 1, 1}, "not a seed: 16 hexadecimal digits were expected");
    return seed;
}

std::uint64_t agreed_seed(const fs::path& results, const std::optional<fs::path>& given) {
    const fs::path file = seed_file(results);
    const std::uint64_t proposed = given ? read_seed(*given) : random_bits();
    if (!fs::exists(file)) store(proposed, file);
    const std::uint64_t seed = read_seed(file);
    if (given && seed != proposed)
        throw InputError({file}, "is a different seed than " + given->string() +
                                     ": a run with another seed needs another --out");
    return seed;
}

std::string seed_identifier(std::uint64_t seed) {
    return text_of(keyed_hash({seed, 0}, "identifier of the seed")).substr(0, identifier_digits);
}

}  // namespace rt::grade
