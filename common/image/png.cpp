#include "common/image/png.hpp"

#include "common/system/input_error.hpp"
#include "common/system/whole_file.hpp"

#include <png.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <new>

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

/// The error function of libpng must not return, and may throw: no C stack frame in between owns
/// memory.
[[noreturn]] void fail(png_structp png, png_const_charp message) {
    const auto& file = *static_cast<const std::string*>(png_get_error_ptr(png));
    fail_to_write(file, errno == 0 ? message : std::strerror(errno));
}

void ignore_warning(png_structp /*png*/, png_const_charp /*message*/) {}

/// The two structures of libpng for writing one picture.
class Writer {
public:
    explicit Writer(const std::string& file)
        : name_(file),
          png_(png_create_write_struct(PNG_LIBPNG_VER_STRING, &name_, fail, ignore_warning)),
          info_(png_create_info_struct(png_)) {
        if (info_ == nullptr) {
            png_destroy_write_struct(&png_, nullptr);
            throw std::bad_alloc();
        }
    }
    ~Writer() { png_destroy_write_struct(&png_, &info_); }
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;

    void write(std::FILE* file, const Image& image, const std::vector<PngText>& texts,
               Gamma gamma) {
        errno = 0;
        png_init_io(png_, file);
        png_set_IHDR(png_, info_, png_uint_32(image.resolution.width),
                     png_uint_32(image.resolution.height), 8, PNG_COLOR_TYPE_RGB,
                     PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
        if (gamma == Gamma::linear) png_set_gAMA_fixed(png_, info_, PNG_FP_1);
        if (gamma == Gamma::srgb) png_set_sRGB_gAMA_and_cHRM(png_, info_, PNG_sRGB_INTENT_RELATIVE);
        set_texts(texts);
        png_write_info(png_, info_);
        for (int row = 0; row < image.resolution.height; ++row)
            png_write_row(png_, image[{row, 0}].data());
        png_write_end(png_, nullptr);
    }

private:
    void set_texts(const std::vector<PngText>& texts) {
        for (const PngText& text : texts) {
            png_text chunk{};
            chunk.compression = PNG_ITXT_COMPRESSION_NONE;  // UTF-8
            std::string key = text.key;  // libpng's members are not const; it copies the text
            std::string value = text.value;
            chunk.key = key.data();
            chunk.text = value.data();
            png_set_text(png_, info_, &chunk, 1);
        }
    }

    std::string name_;
    png_structp png_;
    png_infop info_;
};

}  // namespace

void check_writable(const std::string& file) {
    check_place(file);
    check_folder_of(file);
}

void write_png(const std::string& file, const Image& image, const std::vector<PngText>& texts,
               Gamma gamma) {
    check_place(file);
    WholeFile whole(file);
    Writer(file).write(whole.stream(), image, texts, gamma);
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
