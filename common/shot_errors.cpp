#include "common/shot_errors.hpp"

#include <algorithm>
#include <cmath>

namespace rt {

namespace {

double distance(const Shade& a, const Shade& b) {
    double most = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        if (std::isnan(a[i]) != std::isnan(b[i])) return 255;
        if (!std::isnan(a[i])) most = std::max(most, std::abs(a[i] - b[i]));
    }
    return most;
}

}  // namespace

std::vector<double> distances(const Shot& a, const Shot& b) {
    std::vector<double> all;
    for (std::size_t i = 0; i < a.shades.size(); ++i)
        all.push_back(distance(a.shades[i], b.shades[i]));
    return all;
}

double exceptions(std::size_t tried) {
    constexpr double promised = 0.01;
    constexpr double certain = 1.64;  // standard errors
    return std::max(promised - certain * std::sqrt(promised / double(tried)), 0.);
}

double share_beyond(double limit, const std::vector<double>& distances) {
    const auto beyond = std::ranges::count_if(distances, [=](double d) { return d > limit; });
    return double(beyond) / double(distances.size());
}

double error_but_for(double share, std::vector<double> distances) {
    const auto place = distances.end() - 1 - std::ptrdiff_t(share * double(distances.size()));
    std::ranges::nth_element(distances, place);
    return *place;
}

}  // namespace rt
