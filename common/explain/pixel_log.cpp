#include "common/explain/pixel_log.hpp"

namespace rt {

namespace {

constexpr int misses_told = 24;  // about one screenful

}  // namespace

void Story::heading(const std::string& text) {
    out_ << text << '\n';
}

void Story::line(const std::string& name, const std::string& value) {
    out_ << "    " << name << " = " << value << '\n';
}

void Story::remark(const std::string& text) {
    out_ << "    → " << text << '\n';
}

bool Story::room_for_miss() {
    return ++misses_ <= misses_told;
}

int Story::misses_left_out() const {
    return misses_ > misses_told ? misses_ - misses_told : 0;
}

}  // namespace rt
