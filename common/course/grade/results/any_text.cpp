#include "common/course/grade/results/any_text.hpp"

#include "common/system/files.hpp"

#include <utf8proc.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace rt::grade {

namespace {

constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

unsigned byte(char c) {
    return static_cast<unsigned char>(c);
}

void append(std::string& text, unsigned code) {
    std::array<utf8proc_uint8_t, 4> bytes{};
    const auto size = utf8proc_encode_char(utf8proc_int32_t(code), bytes.data());
    text.append(reinterpret_cast<const char*>(bytes.data()), std::size_t(size));
}

bool is_utf8(std::string_view text) {
    while (!text.empty()) {
        utf8proc_int32_t code = 0;
        const auto size = utf8proc_iterate(reinterpret_cast<const utf8proc_uint8_t*>(text.data()),
                                           utf8proc_ssize_t(text.size()), &code);
        if (size <= 0) return false;
        text.remove_prefix(std::size_t(size));
    }
    return true;
}

/// https://www.unicode.org/Public/MAPPINGS/VENDORS/MICSFT/WINDOWS/CP1252.TXT
std::string from_windows(std::string_view bytes) {
    constexpr std::array<unsigned, 32> from_80 = {
        0x20ac, 0x81,   0x201a, 0x0192, 0x201e, 0x2026, 0x2020, 0x2021, 0x02c6, 0x2030, 0x0160,
        0x2039, 0x0152, 0x8d,   0x017d, 0x8f,   0x90,   0x2018, 0x2019, 0x201c, 0x201d, 0x2022,
        0x2013, 0x2014, 0x02dc, 0x2122, 0x0161, 0x203a, 0x0153, 0x9d,   0x017e, 0x0178};
    std::string text;
    for (const char c : bytes) {
        const unsigned code = byte(c);
        append(text, 0x80 <= code && code < 0xa0 ? from_80.at(code - 0x80) : code);
    }
    return text;
}

std::string from_utf16(std::string_view bytes, bool big_end_first) {
    const auto unit = [&](std::size_t i) {
        const unsigned one = byte(bytes[i]);
        const unsigned two = byte(bytes[i + 1]);
        return big_end_first ? one << 8 | two : two << 8 | one;
    };
    std::string text;
    for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
        unsigned code = unit(i);
        const bool is_first_half = 0xd800 <= code && code < 0xdc00 && i + 3 < bytes.size();
        if (is_first_half) code = 0x10000 + ((code & 0x3ff) << 10 | (unit(i += 2) & 0x3ff));
        append(text, code);
    }
    return text;
}

}  // namespace

AnyText read_any_text(const std::filesystem::path& file) {
    AnyText read{.text = read_text(file)};
    std::string& text = read.text;
    const std::string_view bytes = text;
    read.marked = true;
    if (bytes.starts_with(byte_order_mark))
        text.erase(0, byte_order_mark.size());
    else if (bytes.starts_with("\xff\xfe") || bytes.starts_with("\xfe\xff"))
        text = from_utf16(bytes.substr(2), bytes[0] == '\xfe');
    else if (!is_utf8(bytes))
        text = from_windows(bytes);
    else
        read.marked = false;
    if (text.find('\n') == std::string::npos) std::replace(text.begin(), text.end(), '\r', '\n');
    return read;
}

}  // namespace rt::grade
