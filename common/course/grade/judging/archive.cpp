#include "common/course/grade/judging/archive.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <sstream>

namespace rt::grade {

namespace {

constexpr std::size_t largest_source = 256 * 1024;
constexpr std::size_t largest_list = 32 << 20;

/// The names in unpack.cpp.
constexpr std::array kinds = {"folder", "other", "source",  "archive", "link",
                              "locked", "large", "damaged", "nameless"};

/// The bytes of a plain file that has no more than that.
std::optional<std::string> plain_bytes(const fs::path& file, std::size_t largest) {
    const int source = open(file.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (source == -1) return std::nullopt;
    struct stat about {};
    std::optional<std::string> text;
    if (fstat(source, &about) == 0 && S_ISREG(about.st_mode) &&
        std::size_t(about.st_size) <= largest) {
        text.emplace(std::size_t(about.st_size) + 1, '\0');
        std::size_t size = 0;
        ssize_t count = 0;
        while (size < text->size() &&
               (count = read(source, text->data() + size, text->size() - size)) > 0)
            size += std::size_t(count);
        if (count < 0 || size > largest)
            text.reset();
        else
            text->resize(size);
    }
    close(source);
    return text;
}

bool is_readable(const fs::path& file) {
    std::error_code none;
    return fs::is_regular_file(fs::symlink_status(file, none)) && access(file.c_str(), R_OK) == 0;
}

/// The list is untrusted: the archive may have taken control of the tool.
Unpacked read_list(const std::string& text, const fs::path& folder) {
    Unpacked unpacked;
    std::size_t at = 0;
    while (at < text.size()) {
        const std::size_t end = text.find('\n', at);
        if (end == std::string::npos) break;
        std::istringstream line(text.substr(at, end - at));
        std::string kind;
        unsigned number = 0;
        std::size_t length = 0;
        if (!(line >> kind >> number >> length) || length > text.size() - end - 1) break;
        at = end + 1 + length + 1;
        if (kind == "end") unpacked.whole = true;
        const auto known = std::ranges::find(kinds, kind);
        if (known == kinds.end()) break;
        unpacked.entries.push_back({.kind = Entry::Kind(known - kinds.begin()),
                                    .name = text.substr(end + 1, length),
                                    .file = folder / std::to_string(number)});
    }
    return unpacked;
}

}  // namespace

std::optional<Unpacked> unpack(const BuildDirectory& workshop, const fs::path& archive,
                               const fs::path& folder, int megabytes) {
    const fs::path tool = workshop.folder / "unpack";
    if (!is_readable(archive)) return std::nullopt;
    const ProcessResult ending = run_sealed(workshop, folder, {tool},
                                            {tool, folder, std::to_string(megabytes)}, {}, archive);
    const std::optional<std::string> list = plain_bytes(folder / "list", largest_list);
    Unpacked unpacked = read_list(list.value_or(""), folder);
    if (ending.status != 0) unpacked.whole = false;
    const auto is_damaged = [](const Entry& each) { return each.kind == Entry::Kind::damaged; };
    if (!unpacked.whole || std::ranges::any_of(unpacked.entries, is_damaged)) check_space(folder);
    if (!unpacked.whole && unpacked.entries.empty()) return std::nullopt;
    return unpacked;
}

std::optional<std::string> source_text(const fs::path& file) {
    return plain_bytes(file, largest_source);
}

}  // namespace rt::grade
