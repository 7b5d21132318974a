#include "common/image/encode_png.hpp"

#include "common/system/input_error.hpp"

#include <png.h>

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <new>
#include <numeric>

namespace rt {

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
