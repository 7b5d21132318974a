#include "common/course/own/ppm.hpp"

#include "common/system/files.hpp"
#include "common/system/input_error.hpp"
#include "common/system/translation.hpp"

#include <cctype>
#include <filesystem>
#include <optional>

namespace rt {

namespace {

constexpr int brightest = 255;
constexpr std::size_t channels = 3;

class PpmReader {
public:
    PpmReader(const std::string& file, Resolution expected)
        : name_(std::filesystem::path(file).filename().string()),
          text_(read_text(file)),
          expected_(expected) {}

    [[nodiscard]] Image read() {
        const std::string kind = text_.substr(0, 2);
        if (kind != "P6" && kind != "P3") fail(tr("is not a PPM: it does not start with P6 or P3"));
        at_ = 2;
        const int width = header(to_translate("has no width after {kind}"));
        const int height = header(to_translate("has no height after {kind}"));
        if (width != expected_.width || height != expected_.height)
            fail(tr("has the size {size}, not the scene's, {expected}",
                    {{"size", std::to_string(width) + " x " + std::to_string(height)},
                     {"expected", std::to_string(expected_.width) + " x " +
                                      std::to_string(expected_.height)}}));
        const int most = header(to_translate("has no largest level after {kind}"));
        if (most != brightest)
            fail(tr("has the largest level {level}, not 255", {{"level", std::to_string(most)}}));
        ++at_;  // exactly one blank before the colors
        Image image(expected_);
        kind == "P6" ? read_bytes(image) : read_numbers(image);
        return image;
    }

private:
    [[noreturn]] void fail(const std::string& what) const { throw InputError({name_}, what); }

    /// The next decimal number; nothing if something else follows, or a number of seven digits.
    std::optional<int> number() {
        constexpr std::size_t most_digits = 6;
        while (at_ < text_.size() && (std::isspace(byte(at_)) != 0 || text_[at_] == '#'))
            at_ = text_[at_] == '#' ? std::min(text_.find('\n', at_), text_.size()) : at_ + 1;
        const std::size_t start = at_;
        while (at_ < text_.size() && std::isdigit(byte(at_)) != 0) ++at_;
        if (at_ == start || at_ - start > most_digits) return std::nullopt;
        return std::stoi(text_.substr(start, at_ - start));
    }

    int header(const std::string& missing) {
        const std::optional<int> value = number();
        if (!value) fail(tr(missing, {{"kind", text_.substr(0, 2)}}));
        return *value;
    }

    void read_bytes(Image& image) {
        const std::size_t wanted = channels * image.pixels.size();
        const std::size_t there = text_.size() - std::min(at_, text_.size());
        if (there != wanted)
            fail(tr("has {number} bytes of colors, not {all}, three for each pixel",
                    {{"number", std::to_string(there)}, {"all", std::to_string(wanted)}}));
        for (Rgb& pixel : image.pixels)
            for (std::uint8_t& level : pixel) level = byte(at_++);
    }

    void read_numbers(Image& image) {
        for (Rgb& pixel : image.pixels)
            for (std::uint8_t& level : pixel) {
                const std::optional<int> value = number();
                if (!value || *value > brightest)
                    fail(tr("has no {number} numbers from 0 to 255, three for each pixel",
                            {{"number", std::to_string(channels * image.pixels.size())}}));
                level = static_cast<std::uint8_t>(*value);
            }
    }

    [[nodiscard]] unsigned char byte(std::size_t at) const {
        return static_cast<unsigned char>(text_[at]);
    }

    std::string name_;
    std::string text_;
    Resolution expected_;
    std::size_t at_ = 0;
};

}  // namespace

Image read_ppm(const std::string& file, Resolution expected) {
    return PpmReader(file, expected).read();
}

}  // namespace rt
