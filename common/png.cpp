#include "common/png.hpp"

#include "common/input_error.hpp"

#include <png.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>

namespace rt {

namespace {

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

[[noreturn]] void fail(png_structp png, png_const_charp message) {
    throw InputError({*static_cast<const std::string*>(png_get_error_ptr(png))}, message);
}

void ignore_warning(png_structp /*png*/, png_const_charp /*message*/) {}

[[noreturn]] void fail_to_write(const std::string& file) {
    throw InputError({file}, std::string("cannot be written: ") + std::strerror(errno));
}

/// libpng's two structures for one picture that is written. It must not be thrown through C
/// frames that hold memory; libpng's own error function never returns, and may throw.
class Writer {
public:
    explicit Writer(const std::string& file)
        : name_(file),
          png_(png_create_write_struct(PNG_LIBPNG_VER_STRING, &name_, fail, ignore_warning)),
          info_(png_create_info_struct(png_)) {}
    ~Writer() { png_destroy_write_struct(&png_, &info_); }
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;

    void write(std::FILE* file, const Image& image, const std::vector<PngText>& texts) {
        png_init_io(png_, file);
        png_set_IHDR(png_, info_, png_uint_32(image.resolution.width),
                     png_uint_32(image.resolution.height), 8, PNG_COLOR_TYPE_RGB,
                     PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
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
            std::string key = text.key;                     // libpng takes no const, and copies
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

void write_whole(const std::string& part, const Image& image, const std::vector<PngText>& texts) {
    File file(std::fopen(part.c_str(), "wb"));
    if (!file) fail_to_write(part);
    Writer(part).write(file.get(), image, texts);
    if (std::fclose(file.release()) != 0) fail_to_write(part);
}

}  // namespace

void write_png(const std::string& file, const Image& image, const std::vector<PngText>& texts) {
    namespace fs = std::filesystem;
    const fs::path folder = fs::path(file).parent_path();
    const std::string part = file + ".part";
    std::error_code error;
    if (!folder.empty()) fs::create_directories(folder, error);
    if (error) throw InputError({folder.string()}, "cannot be made: " + error.message());
    try {
        write_whole(part, image, texts);
        fs::rename(part, file);
    } catch (const fs::filesystem_error& failure) {
        fs::remove(part, error);
        throw InputError({file}, "cannot be written: " + failure.code().message());
    } catch (const InputError&) {
        fs::remove(part, error);
        throw;
    }
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
