#include "common/image/png.hpp"

#include "common/image/encode_png.hpp"
#include "common/system/input_error.hpp"
#include "common/system/whole_file.hpp"

#include <png.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <string_view>

namespace rt {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail_to_write(const std::string& file, const std::string& why) {
    throw InputError({file}, "cannot be written: " + why);
}

constexpr std::size_t signature_size = 8;

/// Returns whether the file is empty or starts with the signature of a PNG.
bool may_be_replaced(std::FILE* file) {
    std::array<png_byte, signature_size> bytes{};
    const std::size_t count = std::fread(bytes.data(), 1, bytes.size(), file);
    return count == 0 ? std::ferror(file) == 0
                      : count == bytes.size() && png_sig_cmp(bytes.data(), 0, count) == 0;
}

/// Throws InputError if the target is not a replaceable picture: renaming would also replace a
/// device, and a file without write permission.
void check_place(const std::string& file) {
    const fs::path target = behind_links(file);
    std::error_code not_there;
    const fs::file_status status = fs::status(file, not_there);  // also of a pipe: /dev/stdout
    if (file == "-" || (fs::exists(status) && !fs::is_regular_file(status)))
        throw InputError({file},
                         "is not the name of a file: a picture is not written to a folder, a "
                         "device, a pipe or the standard output");
    if (!fs::exists(status)) {
        if (!target.has_filename()) fail_to_write(file, "it is the name of a folder");
        return;
    }
    std::FILE* const older = std::fopen(target.string().c_str(), "r+b");
    if (older == nullptr) fail_to_write(file, std::strerror(errno));
    const bool replaced = may_be_replaced(older);
    std::fclose(older);
    if (!replaced)
        throw InputError({file},
                         "exists and is not a PNG file, so the picture does not replace it: "
                         "expected another name");
}

}  // namespace

void check_writable(const std::string& file) {
    check_place(file);
    check_folder_of(file);
}

void write_png(const std::string& file, const Image& image, const std::vector<PngText>& texts,
               Gamma gamma) {
    check_place(file);
    WholeFile whole(file);
    encode_png(image, texts, gamma, file, [&whole](std::string_view part) { whole.write(part); });
    check_place(file);  // the target may have changed meanwhile
    whole.take_its_place();
}

Image read_png(const std::string& file) {
    png_image header{};
    header.version = PNG_IMAGE_VERSION;
    if (png_image_begin_read_from_file(&header, file.c_str()) == 0)
        throw InputError({file}, header.message);
    header.format = PNG_FORMAT_RGB;
    Image image(Resolution{int(header.width), int(header.height)});
    if (png_image_finish_read(&header, nullptr, image.pixels.data(), 0, nullptr) == 0)
        throw InputError({file}, header.message);
    return image;
}

}  // namespace rt
