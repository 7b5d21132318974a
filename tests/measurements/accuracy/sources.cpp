// The errors that single settings cause in eight pictures: their defaults, and coarser and
// finer values. An error is the root mean square of the differences, in levels of 255, and beside
// it stands the structural similarity.
#include "common/image/png.hpp"
#include "common/program/renderer.hpp"
#include "common/tuning/candidates.hpp"

#include "tests/measurements/accuracy/drawing.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

using namespace rt;

namespace {

namespace fs = std::filesystem;

constexpr Resolution size{.width = 160, .height = 120};
constexpr int many_samples = 256;
constexpr int many_shadow_samples = 1024;
constexpr int deep = 64;

const fs::path scenes = RAYSTEPS_ROOT "/scenes";

std::string rounded_word(const std::string& word) {
    if (word.starts_with("meshes/")) return (scenes / word).string();
    double value = 0;
    const char* const end = word.data() + word.size();
    const auto read = std::from_chars(word.data(), end, value);
    if (read.ptr != end || read.ec != std::errc()) return word;
    char text[40];
    std::snprintf(text, sizeof text, "%.17g", double(float(value)));
    return text;
}

/// Writes the scene with the numbers that float has for its own.
void write_rounded(const fs::path& scene, const fs::path& rounded) {
    std::stringstream whole;
    whole << std::ifstream(scene).rdbuf();
    const std::string text = whole.str();
    std::ofstream file(rounded);
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t end = std::min(text.find_first_of(" \t\n,:", i), text.size());
        file << rounded_word(text.substr(i, end - i));
        if (end < text.size()) file << text[end];
        i = end + 1;
    }
}

constexpr int reach = 5;  // of the window, on each side of its pixel
constexpr int side = 2 * reach + 1;

/// The window of the article: a Gaussian of 1.5 pixels, whose weights add up to 1.
std::array<double, std::size_t(side)> window() {
    std::array<double, std::size_t(side)> weights{};
    double sum = 0;
    for (int i = 0; i < side; ++i)
        sum += weights[std::size_t(i)] = std::exp(-0.5 * std::pow((i - reach) / 1.5, 2));
    for (double& weight : weights) weight /= sum;
    return weights;
}

/// The index of one channel in the window around a pixel.
double local_similarity(const Image& a, const Image& b, Pixel middle, std::size_t channel) {
    static const auto weights = window();
    double x = 0;
    double y = 0;
    double xx = 0;
    double yy = 0;
    double xy = 0;
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column) {
            const Pixel pixel{.row = middle.row + row - reach,
                              .column = middle.column + column - reach};
            const double weight = weights[std::size_t(row)] * weights[std::size_t(column)];
            const double p = a[pixel][channel];
            const double q = b[pixel][channel];
            x += weight * p;
            y += weight * q;
            xx += weight * p * p;
            yy += weight * q * q;
            xy += weight * p * q;
        }
    const double c1 = std::pow(0.01 * 255, 2);  // the article's constants
    const double c2 = std::pow(0.03 * 255, 2);
    return (2 * x * y + c1) * (2 * (xy - x * y) + c2) /
           ((x * x + y * y + c1) * (xx - x * x + yy - y * y + c2));
}

/// The structural similarity of two pictures of the same size, 11 pixels or more on a side: the
/// mean over the three channels and over all windows that lie in the picture; 1 for equal pictures.
/// Wang, Bovik, Sheikh and Simoncelli, "Image quality assessment: from error visibility to
/// structural similarity", 2004, with their window and constants.
double structural_similarity(const Image& a, const Image& b) {
    double sum = 0;
    double count = 0;
    for (Pixel p{.row = reach}; p.row < a.resolution.height - reach; ++p.row)
        for (p.column = reach; p.column < a.resolution.width - reach; ++p.column)
            for (std::size_t channel = 0; channel < 3; ++channel, ++count)
                sum += local_similarity(a, b, p, channel);
    return sum / count;
}

class Study {
public:
    Study(const std::string& name, fs::path folder) : name_(name), folder_(std::move(folder)) {
        Options options{};
        options.scene = (scenes / (name + ".rt")).string();
        options.size = size;
        traits_ = f64::make_renderer({.stage = 13, .root = RAYSTEPS_ROOT}, options)->traits();
        file_ = options.scene;
        draw_ = f64::drawer(file_, size);
    }

    void measure() {
        const RenderSettings usual;
        const Image one = draw_(usual).image;
        const bool sized = traits_.sized_lights;
        const auto calm = [&](int rays) { return sized ? with_rays(usual, rays) : usual; };
        const Image calm_one = sized ? draw_(calm(many_shadow_samples)).image : one;
        aliasing(calm_one, calm(1), calm(many_shadow_samples / 4));
        for (const int rays : {1, 4, 16})
            add("shadows", rays, calm_one, sized ? draw_(with_rays(usual, rays)).image : one);
        const Image deepest = draw_({.depth = deep}).image;
        for (const int depth : {0, 1, 2, 4, 8})
            add("depth", depth, deepest, draw_({.depth = depth}).image);
        add("precision", 0, one, f32::drawn(file_, size, usual).image);
        const fs::path rounded = folder_ / (name_ + ".rt");
        write_rounded(file_, rounded);
        add("input rounding", 0, one, f64::drawn(rounded.string(), size, usual).image);
        print();
    }

private:
    struct Row {
        const char* source;
        int value;
        Difference off;
        double similarity;
    };

    void aliasing(const Image& one, RenderSettings right, RenderSettings some) {
        right.pixel_samples = many_samples;
        const Image exact = draw_(right).image;
        add("aliasing", 1, exact, one);
        for (const int count : {4, 16}) {
            some.pixel_samples = count;
            add("aliasing", count, exact, draw_(some).image);
        }
    }

    [[nodiscard]] std::string file_of(std::size_t row, const char* which) const {
        return (folder_ / (name_ + "_" + rows_[row].source + "_" +
                           std::to_string(rows_[row].value) + "_" + which + ".png"))
            .string();
    }

    void add(const char* source, int value, const Image& right, const Image& picture) {
        rows_.push_back(
            {source, value, difference(picture, right), structural_similarity(picture, right)});
        write_png(file_of(rows_.size() - 1, "right"), right, {});
        write_png(file_of(rows_.size() - 1, "picture"), picture, {});
    }

    void print() const {
        for (const auto& [source, value, off, similarity] : rows_)
            std::printf("%s,%s,%d,%.4g,%d,%.5f,%.6f\n", name_.c_str(), source, value, off.error,
                        off.most, off.seen, similarity);
        std::fflush(stdout);
    }

    std::string name_;
    std::string file_;
    fs::path folder_;
    SceneTraits traits_;
    Drawer draw_;
    std::vector<Row> rows_;
};

}  // namespace

/// With a folder as argument, the pictures stay there. With two pictures, prints their similarity.
int main(int count, char** arguments) {
    if (count > 2) {
        std::printf("%.6f\n",
                    structural_similarity(read_png(arguments[1]), read_png(arguments[2])));
        return 0;
    }
    const std::string number = std::to_string(std::random_device()());
    const fs::path folder = count > 1 ? fs::path(arguments[1])
                                      : fs::temp_directory_path() / ("raysteps_sources." + number);
    fs::create_directories(folder);
    std::puts("scene,source,value,error,most,seen,similarity");
    for (const char* scene :
         {"step04_plane", "step08_cone", "step10_shadows", "cornell_box", "step11_soft_shadows",
          "cornell_mirror", "step12_mirror", "step13_meshes"})
        Study(scene, folder).measure();
    if (count == 1) fs::remove_all(folder);
}
