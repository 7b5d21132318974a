// Pictures in the bytes of a PNG file, compressed as it suits them.
#pragma once

#include "common/image/png.hpp"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace rt {

/// Receives the bytes of a file, a part at a time.
using ByteSink = std::function<void(std::string_view)>;

/// Passes a PNG file of the picture to `sink`. Filter and compression are those, of three, that
/// make the fewest bytes of a few of its rows: a picture has the same bytes wherever zlib is the
/// same. Throws InputError with this name of the file if libpng fails.
void encode_png(const Image& image, const std::vector<PngText>& texts, Gamma gamma,
                const std::string& name, const ByteSink& sink);

}  // namespace rt
