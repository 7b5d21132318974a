// PNG files, through libpng.
#pragma once

#include "common/image.hpp"

#include <string>
#include <vector>

namespace rt {

/// A text chunk: what a picture says of itself ("Title", "Size", …).
struct PngText {
    std::string key;
    std::string value;
};

/// Writes the picture, or nothing: it is a WholeFile. Makes the folder if there is none. Throws
/// InputError if that fails, or if a file is there that is neither a PNG nor empty.
void write_png(const std::string& file, const Image& image, const std::vector<PngText>& texts);

/// Throws InputError if write_png could not write there. Leaves nothing.
void check_writable(const std::string& file);

/// Reads 8-bit colours out of any PNG. Throws InputError if the file is none.
[[nodiscard]] Image read_png(const std::string& file);

}  // namespace rt
