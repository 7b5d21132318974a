#include "common/program/make_picture.hpp"

#include "common/image/color_scale.hpp"
#include "common/system/text.hpp"
#include "common/tuning/wording.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <utility>

namespace rt {

namespace {

constexpr std::size_t most_shapes_named = 24;

std::string title(Shading shading) {
    switch (shading) {
        case Shading::depth:
            return "depth: the distance from the eye to what the ray hits, in units of the scene; "
                   "black: nothing is hit";
        case Shading::t:
            return "t: that of the closest hit of d_r, as long as stage 1 makes it; black: nothing "
                   "is hit";
        case Shading::id:
            return "id: the shape that the ray hits; black: nothing is hit";
        case Shading::bounces:
            return "bounces: the reflections off mirrors before a pixel's last ray; black: nothing "
                   "is hit";
        case Shading::samples:
            return "samples: the number of rays whose mean the pixel is";
        case Shading::cost:
            return "cost: the number of shapes, and of boxes and triangles inside meshes, that a "
                   "pixel's rays are tested against; black: none";
        case Shading::color:
        case Shading::normal:
            break;
    }
    return "";
}

/// A logarithmic scale of colors.
struct Scale {
    double low = 1;
    double high = 1;
    bool is_open = false;  ///< there are larger numbers, with the color of the end

    [[nodiscard]] double share(double number) const {
        if (!(number > low)) return 0;
        return number < high ? std::log(number / low) / std::log(high / low) : 1;
    }
};

/// The next number with four digits, below or above: the one that the legend prints.
double four_digits(double number, double (*round)(double)) {
    const double power = std::pow(10, std::floor(std::log10(number)) - 3);
    return std::strtod(formatted("%.4g", power * round(number / power)).c_str(), nullptr);
}

Scale scale_of(const PixelValues& values, const Options& options) {
    if (const auto& range = options.shade_range) return {.low = (*range)[0], .high = (*range)[1]};
    std::vector<float> numbers;
    for (const auto& number : values.numbers)
        if (number && *number > 0 && std::isfinite(*number)) numbers.push_back(*number);
    if (numbers.empty()) return {};
    const auto [low, high] = std::ranges::minmax_element(numbers);
    Scale scale{.low = four_digits(*low, std::floor), .high = four_digits(*high, std::ceil)};
    const Shading shading = options.settings.shading;
    if (shading != Shading::depth && shading != Shading::t) return scale;
    // A plane goes on to the horizon, and would leave few colors for what is near.
    const auto far = numbers.begin() + std::ptrdiff_t(0.95 * double(numbers.size()));
    std::nth_element(numbers.begin(), far, numbers.end());
    const double most = four_digits(*far, std::ceil);
    if (scale.low < most && 2 * most < scale.high) {
        scale.high = most;
        scale.is_open = true;
    }
    return scale;
}

/// Round numbers between the ends: 1, 2 and 5 of each power of ten, powers of ten, or equal steps.
std::vector<double> round_numbers(const Scale& scale) {
    std::vector<double> round;
    const double ratio = scale.high / scale.low;
    if (ratio < 5) {
        const double wanted = (scale.high - scale.low) / 5;
        const double power = std::pow(10, std::floor(std::log10(wanted)));
        const double step = power * (wanted > 5 * power ? 10 : wanted > 2 * power ? 5 : 2);
        // Counted: in a very narrow scale, a step may be below the digits of its numbers.
        constexpr int most = 5;
        const double first = std::ceil(scale.low / step);
        for (int i = 0; i <= most && (first + i) * step < scale.high; ++i)
            round.push_back((first + i) * step);
    } else {
        const bool all = ratio < 3000;
        constexpr double most = 20;  // powers of ten
        const double apart = std::pow(10, 1 + std::floor(std::log10(ratio) / most));
        for (double power = std::pow(10, std::floor(std::log10(scale.low))); power < scale.high;
             power *= apart)
            for (const int factor : {1, 2, 5})
                if (all || factor == 1) round.push_back(factor * power);
    }
    return round;
}

std::vector<std::string> ticks(const Scale& scale) {
    if (!(scale.low < scale.high))
        return {hex(scale_color(0)) + formatted("    0 %%  %.4g", scale.low)};
    constexpr double apart = 0.05;  // closer numbers would overlap
    std::vector<double> numbers = {scale.low};
    for (const double number : round_numbers(scale))
        if (scale.share(number) > apart && scale.share(number) < 1 - apart)
            numbers.push_back(number);
    numbers.push_back(scale.high);
    std::vector<std::string> lines;
    for (const double number : numbers) {
        const double share = scale.share(number);
        lines.push_back(hex(scale_color(share)) +
                        formatted("  %3.0f %%  %.4g", 100 * share, number));
    }
    if (scale.is_open) lines.back() += " and more";
    return lines;
}

/// The lines of numbers that are names: of shapes, or of how many reflections.
std::vector<std::string> keys(const PixelValues& values, const Scene& scene, Shading shading,
                              const auto& color) {
    std::map<int, std::size_t> counts;
    for (const auto& number : values.numbers)
        if (number) ++counts[int(*number)];
    std::vector<std::pair<int, std::size_t>> largest(counts.begin(), counts.end());
    std::ranges::stable_sort(largest, std::greater(), [](const auto& each) { return each.second; });
    std::vector<std::string> lines;
    const std::size_t named = std::min(largest.size(), most_shapes_named);
    std::sort(largest.begin(), largest.begin() + std::ptrdiff_t(named));
    for (std::size_t i = 0; i < named; ++i) {
        const auto& [value, count] = largest[i];
        const std::string name =
            shading == Shading::id ? name_of_shape(value, scene) : std::to_string(value);
        lines.push_back(hex(color(value)) + "  " + name + ", " +
                        number(100 * double(count) / double(values.numbers.size())) +
                        " % of the pixels");
    }
    if (named < largest.size())
        lines.push_back("and " + std::to_string(largest.size() - named) + " smaller ones");
    return lines;
}

}  // namespace

ShadePicture shade_picture(const PixelValues& values, const Options& options, const Scene& scene) {
    const RenderSettings& settings = options.settings;
    const Shading shading = settings.shading;
    ShadePicture picture{.image = Image(values.resolution), .legend = {title(shading)}};
    const auto paint = [&](const auto& color) {
        for (std::size_t i = 0; i < values.numbers.size(); ++i)
            if (const auto& number = values.numbers[i])
                picture.image.pixels[i] = std::isnan(*number) ? not_a_color : color(*number);
    };
    std::vector<std::string> lines;
    if (shading == Shading::id || shading == Shading::bounces) {
        const auto color = [&](auto number) {
            return shading == Shading::id
                       ? distinct_color(int(number))
                       : scale_color(std::log1p(double(number)) /
                                     std::log1p(double(std::max(settings.depth, 1))));
        };
        paint(color);
        lines = keys(values, scene, shading, color);
    } else {
        const Scale scale = scale_of(values, options);
        paint([&](float number) { return scale_color(scale.share(double(number))); });
        lines = ticks(scale);
    }
    picture.legend.insert(picture.legend.end(), lines.begin(), lines.end());
    return picture;
}

}  // namespace rt
