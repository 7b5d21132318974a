#include "common/explain/pixel_log.hpp"

namespace rt {

namespace {

constexpr int most_misses = 24;      // about one screenful
constexpr int most_shadow_rays = 3;  // of one light

}  // namespace

void PixelLog::heading(const std::string& text) {
    out_ << text << '\n';
    shadow_rays_ = 0;
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

PixelLog::ShadowTest PixelLog::shadow_test(std::int64_t ray) {
    const bool is_first = ray != shadow_ray_;
    if (is_first) ++shadow_rays_;
    shadow_ray_ = ray;
    if (shadow_rays_ > most_shadow_rays) return ShadowTest::left_out;
    return is_first ? ShadowTest::first_of_ray : ShadowTest::later;
}

int PixelLog::misses_left_out() const {
    return misses_ > most_misses ? misses_ - most_misses : 0;
}

}  // namespace rt
