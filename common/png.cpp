#include "common/png.hpp"

#include "common/input_error.hpp"

#include <png.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <new>
#include <utility>

namespace rt {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail_to_write(const std::string& file, const std::string& why) {
    throw InputError({file}, "cannot be written: " + why);
}

/// A file that is written beside the one that is meant, and takes its place once it is whole.
class PartFile {
public:
    explicit PartFile(const std::string& file) : file_(file), part_(file + ".part") {
        const fs::path folder = fs::path(file).parent_path();
        std::error_code error;
        if (!folder.empty()) fs::create_directories(folder, error);
        if (error) throw InputError({folder.string()}, "cannot be made: " + error.message());
        // Renaming would replace a device, too.
        const fs::file_status status = fs::status(file, error);
        if (fs::exists(status) && !fs::is_regular_file(status))
            throw InputError({file}, "is a folder or a device: expected a name for the picture");
        stream_ = std::fopen(part_.c_str(), "wb");
        if (stream_ == nullptr) fail_to_write(file_, std::strerror(errno));
    }
    ~PartFile() {
        if (stream_ != nullptr) std::fclose(stream_);
        std::error_code not_there;
        fs::remove(part_, not_there);
    }
    PartFile(const PartFile&) = delete;
    PartFile& operator=(const PartFile&) = delete;

    [[nodiscard]] std::FILE* stream() const { return stream_; }

    void take_its_place() {
        if (std::fclose(std::exchange(stream_, nullptr)) != 0)
            fail_to_write(file_, std::strerror(errno));
        std::error_code error;
        fs::rename(part_, file_, error);
        if (error) fail_to_write(file_, error.message());
    }

private:
    std::string file_;
    std::string part_;
    std::FILE* stream_ = nullptr;
};

/// libpng's error function must not return, and may throw: no C frame between holds memory.
[[noreturn]] void fail(png_structp png, png_const_charp message) {
    const auto& file = *static_cast<const std::string*>(png_get_error_ptr(png));
    fail_to_write(file, errno == 0 ? message : std::strerror(errno));
}

void ignore_warning(png_structp /*png*/, png_const_charp /*message*/) {}

/// libpng's two structures for one picture that is written.
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

    void write(std::FILE* file, const Image& image, const std::vector<PngText>& texts) {
        errno = 0;
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

}  // namespace

void check_writable(const std::string& file) {
    const PartFile begun(file);
}

void write_png(const std::string& file, const Image& image, const std::vector<PngText>& texts) {
    PartFile part(file);
    Writer(file).write(part.stream(), image, texts);
    part.take_its_place();
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
