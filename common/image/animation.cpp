#include "common/image/animation.hpp"

#include "common/image/png.hpp"
#include "common/system/whole_file.hpp"

#include <zlib.h>

#include <cstdint>
#include <string_view>

namespace rt {

namespace {

constexpr std::string_view signature = "\x89PNG\r\n\x1a\n";

/// The bytes of an unsigned number, the most significant first.
std::string bytes(std::uint32_t number, int count = 4) {
    std::string text;
    for (int shift = 8 * (count - 1); shift >= 0; shift -= 8) text += char(number >> shift & 255U);
    return text;
}

std::string chunk(std::string_view type, const std::string& data) {
    const std::string body = std::string(type) + data;
    const auto* const first = reinterpret_cast<const Bytef*>(body.data());
    return bytes(std::uint32_t(data.size())) + body +
           bytes(std::uint32_t(crc32(0, first, uInt(body.size()))));
}

/// The joined content of the chunks IDAT of a PNG file.
std::string image_data(std::string_view png) {
    std::string data;
    png.remove_prefix(signature.size());
    while (!png.empty()) {
        std::uint32_t size = 0;
        for (int i = 0; i < 4; ++i) size = size << 8U | std::uint8_t(png[std::size_t(i)]);
        if (png.substr(4, 4) == "IDAT") data += png.substr(8, size);
        png.remove_prefix(12 + std::size_t(size));  // with its length, type and checksum
    }
    return data;
}

}  // namespace

void Animation::add(const Image& frame) {
    resolution_ = frame.resolution;
    std::string png;
    encode_png(frame, {}, Gamma::unstated, "", [&png](std::string_view part) { png += part; });
    frames_.push_back(image_data(png));
}

void Animation::write(const std::string& file, int milliseconds, const std::vector<PngText>& texts,
                      Gamma gamma) const {
    check_writable(file);
    WholeFile whole(file);
    whole.write(signature);
    const std::string size =
        bytes(std::uint32_t(resolution_.width)) + bytes(std::uint32_t(resolution_.height));
    const std::string form{8, 2, 0, 0, 0};  // bits, RGB, the only compression, filter, no interlace
    whole.write(chunk("IHDR", size + form));
    if (gamma == Gamma::linear) whole.write(chunk("gAMA", bytes(100000)));
    if (gamma == Gamma::srgb) whole.write(chunk("sRGB", bytes(1, 1)));  // relative colorimetric
    whole.write(chunk("acTL", bytes(std::uint32_t(frames_.size())) + bytes(0)));  // without end
    for (const PngText& text : texts) {
        // The key's end; not compressed; no language, no other key.
        const std::string zeros(5, '\0');
        whole.write(chunk("iTXt", text.key + zeros + text.value));
    }
    std::uint32_t number = 0;  // of the chunks fcTL and fdAT, together
    for (const std::string& frame : frames_) {
        const std::string time = bytes(std::uint32_t(milliseconds), 2) + bytes(1000, 2);
        const std::string place = bytes(0) + bytes(0);
        const std::string whole_frame(2, '\0');  // kept afterwards, and replaces what was there
        whole.write(chunk("fcTL", bytes(number++) + size + place + time + whole_frame));
        whole.write(&frame == &frames_.front() ? chunk("IDAT", frame)
                                               : chunk("fdAT", bytes(number++) + frame));
    }
    whole.write(chunk("IEND", ""));
    check_writable(file);  // the target may have changed meanwhile
    whole.take_its_place();
}

}  // namespace rt
