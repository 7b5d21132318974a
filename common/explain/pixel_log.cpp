#include "common/explain/pixel_log.hpp"

namespace rt {

namespace {

constexpr int most_misses = 24;  // about one screenful

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
    return ++misses_ <= most_misses;
}

int PixelLog::misses_left_out() const {
    return misses_ > most_misses ? misses_ - most_misses : 0;
}

}  // namespace rt
