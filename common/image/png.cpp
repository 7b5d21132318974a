#include "common/image/png.hpp"

#include "common/system/input_error.hpp"
#include "common/system/whole_file.hpp"

#include <png.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <new>
#include <numeric>
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

namespace {

/// The filter of every row (PNG, third edition, section 9), and the level and strategy of zlib.
struct Encoding {
    int filter;
    int level;
    int strategy;
};

/// libpng's own choice tries five filters for each row, which takes as long as its compression. Of
/// these the first suits flat colors and patterns, the second smooth shades, and the third what
/// changes from column to column. Runs, which Z_RLE finds, are all that is left of smooth shades.
constexpr std::array<Encoding, 3> encodings = {
    Encoding{.filter = PNG_FILTER_NONE, .level = 5, .strategy = Z_DEFAULT_STRATEGY},
    Encoding{.filter = PNG_FILTER_PAETH, .level = 1, .strategy = Z_RLE},
    Encoding{.filter = PNG_FILTER_UP, .level = 4, .strategy = Z_DEFAULT_STRATEGY},
};

/// The error function of libpng must not return, and may throw: no C stack frame in between owns
/// memory.
[[noreturn]] void fail(png_structp png, png_const_charp message) {
    const auto& file = *static_cast<const std::string*>(png_get_error_ptr(png));
    throw InputError({file}, std::string("cannot be written: ") + message);
}

void ignore_warning(png_structp /*png*/, png_const_charp /*message*/) {}

/// The two structures of libpng for writing one picture.
class Writer {
public:
    /// The sink must outlive this object, and may throw.
    Writer(const std::string& file, const ByteSink& sink)
        : name_(file),
          sink_(sink),
          png_(png_create_write_struct(PNG_LIBPNG_VER_STRING, &name_, fail, ignore_warning)),
          info_(png_create_info_struct(png_)) {
        if (info_ == nullptr) {
            png_destroy_write_struct(&png_, nullptr);
            throw std::bad_alloc();
        }
        const auto write = [](png_structp png, png_bytep bytes, std::size_t count) {
            const auto& to = *static_cast<const ByteSink*>(png_get_io_ptr(png));
            to({reinterpret_cast<const char*>(bytes), count});
        };
        png_set_write_fn(png_, const_cast<ByteSink*>(&sink_), write, [](png_structp) {});
    }
    ~Writer() { png_destroy_write_struct(&png_, &info_); }
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;

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

    void set_gamma(Gamma gamma) {
        if (gamma == Gamma::linear) png_set_gAMA_fixed(png_, info_, PNG_FP_1);
        if (gamma == Gamma::srgb) png_set_sRGB_gAMA_and_cHRM(png_, info_, PNG_sRGB_INTENT_RELATIVE);
    }

    /// Writes a picture of these rows of the image.
    void write(const Image& image, const std::vector<int>& rows, const Encoding& encoding) {
        png_set_IHDR(png_, info_, png_uint_32(image.resolution.width), png_uint_32(rows.size()), 8,
                     PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                     PNG_FILTER_TYPE_DEFAULT);
        png_set_filter(png_, PNG_FILTER_TYPE_BASE, encoding.filter);
        png_set_compression_level(png_, encoding.level);
        png_set_compression_strategy(png_, encoding.strategy);
        png_write_info(png_, info_);
        for (const int row : rows) png_write_row(png_, image[{row, 0}].data());
        png_write_end(png_, nullptr);
    }

private:
    std::string name_;
    const ByteSink& sink_;
    png_structp png_;
    png_infop info_;
};

std::vector<int> all_rows(const Image& image) {
    std::vector<int> rows(std::size_t(image.resolution.height));
    std::iota(rows.begin(), rows.end(), 0);
    return rows;
}

/// Two bands of rows, before which a quarter and three quarters of the picture's changes from row
/// to row lie: a part of the background alone would say nothing of the rest.
std::vector<int> some_rows(const Image& image) {
    constexpr int bands = 2;
    constexpr int height = 12;
    const auto [width, all] = image.resolution;
    if (all <= bands * height) return all_rows(image);
    constexpr int together = 16;              // pixels that are compared at once
    std::vector<std::int64_t> changes = {1};  // up to each row; each adds at least one
    for (int row = 1; row < all; ++row) {
        const Rgb* const above = &image[{row - 1, 0}];
        const Rgb* const here = &image[{row, 0}];
        std::int64_t differ = 1;
        for (int column = 0; column < width; column += together) {
            const auto count = std::size_t(std::min(together, width - column));
            if (std::memcmp(above + column, here + column, count * sizeof(Rgb)) != 0) ++differ;
        }
        changes.push_back(changes.back() + differ);
    }
    std::vector<int> rows;
    int next = 0;
    for (int band = 0; band < bands; ++band) {
        const std::int64_t part = changes.back() * (2 * band + 1) / (2 * bands);
        const auto middle = int(std::ranges::lower_bound(changes, part) - changes.begin());
        const int first = std::clamp(middle - height / 2, next, all - height * (bands - band));
        next = first + height;
        for (int row = first; row < next; ++row) rows.push_back(row);
    }
    return rows;
}

Encoding encoding_of(const Image& image) {
    const std::vector<int> rows = some_rows(image);
    const auto size = [&](const Encoding& encoding) {
        std::size_t bytes = 0;
        const ByteSink count = [&bytes](std::string_view part) { bytes += part.size(); };
        Writer("", count).write(image, rows, encoding);
        return bytes;
    };
    return std::ranges::min(encodings, {}, size);
}

}  // namespace

void encode_png(const Image& image, const std::vector<PngText>& texts, Gamma gamma,
                const std::string& name, const ByteSink& sink) {
    const Encoding encoding = encoding_of(image);
    Writer writer(name, sink);
    writer.set_gamma(gamma);
    writer.set_texts(texts);
    writer.write(image, all_rows(image), encoding);
}

}  // namespace rt
