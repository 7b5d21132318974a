#include "common/system/input_file.hpp"

#include "common/system/huge_pages.hpp"
#include "common/system/input_error.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace rt {

std::string read_input_file(const std::string& file, std::size_t limit) {
    std::error_code trouble;
    const auto type = std::filesystem::status(file, trouble).type();
    if (type == std::filesystem::file_type::not_found) throw InputError({file}, "no such file");
    if (type == std::filesystem::file_type::directory) {
        throw InputError({file}, "is a directory: expected a file");
    }
    std::ifstream stream(file, std::ios::binary);

    // In pieces, and not by its size: a pipe has no size, and some files never end.
    constexpr std::size_t piece = 1 << 16;
    std::string content;
    const std::uintmax_t size = std::filesystem::file_size(file, trouble);
    if (!trouble) {
        content.reserve(std::min<std::uintmax_t>(size, limit) + piece);
        request_huge_pages(content.data(), content.capacity());
    }
    while (stream && content.size() <= limit) {
        const std::size_t before = content.size();
        content.resize(std::min(before + piece, limit + 1));
        stream.read(content.data() + before, static_cast<std::streamsize>(content.size() - before));
        content.resize(before + static_cast<std::size_t>(stream.gcount()));
    }
    if (!stream.is_open() || stream.bad()) throw InputError({file}, "cannot be read");
    return content;
}

}  // namespace rt
