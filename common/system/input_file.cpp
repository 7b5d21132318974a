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
    const auto status = std::filesystem::status(file, trouble);
    if (status.type() == std::filesystem::file_type::not_found)
        throw InputError({file}, "no such file");
    if (std::filesystem::is_directory(status))
        throw InputError({file}, "is a directory: expected a file");
    // A device may be endless. A pipe may wait for ever, and cannot be read twice, in each
    // precision.
    if (std::filesystem::exists(status) && std::filesystem::is_other(status))
        throw InputError({file}, "is a device or a pipe: expected a file");
    std::ifstream stream(file, std::ios::binary);

    // In pieces, and not by its size, which a file may not have.
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
