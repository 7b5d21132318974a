// Reading and writing of PNG files, with libpng.
#pragma once

#include "common/image/gamma.hpp"
#include "common/image/image.hpp"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace rt {

/// A text chunk: metadata of the picture ("Title", "Size", …).
struct PngText {
    std::string key;
    std::string value;
};

/// Writes the picture completely or not at all: it is a WholeFile. Creates the folder if needed.
/// Throws InputError if that fails, or if the existing file is neither a PNG nor empty. `gamma` is
/// that of the image's colors: linear is stored as a chunk gAMA, and srgb as a chunk sRGB.
void write_png(const std::string& file, const Image& image, const std::vector<PngText>& texts,
               Gamma gamma = Gamma::unstated);

/// Throws InputError if write_png could not write to the file. Creates no file.
void check_writable(const std::string& file);

/// Reads any PNG file as 8-bit colors. Throws InputError if the file is not a PNG.
[[nodiscard]] Image read_png(const std::string& file);

// Pictures in the bytes of a PNG file, compressed as it suits them.

/// Receives the bytes of a file, a part at a time.
using ByteSink = std::function<void(std::string_view)>;

/// Passes a PNG file of the picture to `sink`. Filter and compression are those, of three, that
/// make the fewest bytes of a few of its rows: a picture has the same bytes wherever zlib is the
/// same. Throws InputError with this name of the file if libpng fails.
void encode_png(const Image& image, const std::vector<PngText>& texts, Gamma gamma,
                const std::string& name, const ByteSink& sink);

}  // namespace rt
