#include "common/explain/pixel_log.hpp"

namespace rt {

namespace {

constexpr int misses_told = 24;  // about one screenful

}  // namespace

void PixelLog::heading(const std::string& text) {
    out_ << text << '\n';
}

void PixelLog::line(const std::string& name, const std::string& value) {
    out_ << "    " << name << " = " << value << '\n';
}

void PixelLog::remark(const std::string& text) {
    out_ << "    → " << text << '\n';
}

bool PixelLog::count_miss() {
    return ++misses_ <= misses_told;
}

int PixelLog::misses_left_out() const {
    return misses_ > misses_told ? misses_ - misses_told : 0;
}

}  // namespace rt
