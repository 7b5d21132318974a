// Animated PNG files (APNG, in the third edition of the PNG specification).
#pragma once

#include "common/image/image.hpp"
#include "common/image/png.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace rt {

/// The frames of an animation, which begins again after the last. Programs that know no animated
/// PNG show the first. Frames are kept compressed.
class Animation {
public:
    /// Adds a frame. All must have the size of the first.
    void add(const Image& frame);

    /// Writes the file completely or not at all, as write_png does, and throws in the same cases.
    /// Each frame is shown for `milliseconds`.
    void write(const std::string& file, int milliseconds, const std::vector<PngText>& texts,
               Gamma gamma) const;

    [[nodiscard]] std::size_t frames() const { return frames_.size(); }
    [[nodiscard]] Resolution resolution() const { return resolution_; }

private:
    Resolution resolution_{0, 0};
    std::vector<std::string> frames_;  ///< the content of the IDAT chunks of each
};

}  // namespace rt
