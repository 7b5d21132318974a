// Pictures whose pixels are known in closed form, beside sampled ones: the error against the number
// of rays, and what the steps from rays to a file's levels are worth. Prints CSV.
#include "common/image/gamma.hpp"
#include "common/render/sampling.hpp"

#include "steps/step04_plane/plane.hpp"
#include "steps/step05_triangle/triangle.hpp"
#include "steps/step11_soft_shadows/soft_shadows.hpp"

#include "tests/measurements/accuracy/shaded_sphere.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <random>
#include <utility>
#include <vector>

namespace {

using namespace rt;

constexpr int width = 48;
constexpr int height = 32;
constexpr int most = 1024;  // rays through a pixel, or to a lamp
constexpr Triangle shape{{3.3, 2.1, 0}, {44.7, 9.4, 0}, {17.2, 29.6, 0}};
constexpr Light lamp{.position = {0, 0, 3}, .radius = 1};
constexpr Plane screen{{0, 0, 1.5}, {0, 0, 1}};  // opaque where x < 0

/// The area of the pixel that the triangle covers: its square clipped at each side, by the shoelace
/// formula.
double covered(Vec2 pixel) {
    std::vector<Vec2> left{pixel, pixel + Vec2(1, 0), pixel + Vec2(1, 1), pixel + Vec2(0, 1)};
    const std::array<Vec2, 3> corners{Vec2(shape.a), Vec2(shape.b), Vec2(shape.c)};
    for (std::size_t side = 0; side < 3; ++side) {
        const Vec2 along = corners[(side + 1) % 3] - corners[side];
        const auto depth = [&](Vec2 p) {
            const Vec2 to = p - corners[side];
            return along.x * to.y - along.y * to.x;
        };
        std::vector<Vec2> inside;
        for (std::size_t i = 0; i < left.size(); ++i) {
            const Vec2 p = left[i];
            const Vec2 q = left[(i + 1) % left.size()];
            if (depth(p) >= 0) inside.push_back(p);
            if (depth(p) * depth(q) < 0)
                inside.push_back(p + depth(p) / (depth(p) - depth(q)) * (q - p));
        }
        left = std::move(inside);
    }
    double twice = 0;
    for (std::size_t i = 0; i < left.size(); ++i) {
        const Vec2 p = left[i] - pixel;
        const Vec2 q = left[(i + 1) % left.size()] - pixel;
        twice += double(p.x * q.y - p.y * q.x);
    }
    return twice / 2;
}

/// The visible part of the lamp from (x, 0, 0). The point and the edge of the screen span a plane,
/// which cuts the cap of directions to the lamp, of half angle α, at a distance δ from its middle:
/// acos(sin δ / sin α) − cos α acos(tan δ / tan α) of π (1 − cos α) are hidden.
double visible(double x) {
    const double sine = double(lamp.radius) / std::hypot(x, double(lamp.position.z));
    const double cosine = std::sqrt(1 - sine * sine);
    const double delta =
        std::atan2(x, double(screen.point.z)) - std::atan2(x, double(lamp.position.z));
    if (std::abs(std::sin(delta)) >= sine) return delta > 0 ? 1 : 0;
    const double hidden =
        std::acos(std::sin(delta) / sine) - cosine * std::acos(std::tan(delta) * cosine / sine);
    return 1 - hidden / (pi * (1 - cosine));
}

struct Known {
    double truth;  ///< from 0 to 1
    Vec2 at;       ///< the pixel's corner, or the x of a point on the ground
};

bool is_seen(const char* picture, const Known& pixel, Vec2 sample) {
    if (picture[0] == 'e') {
        const Vec2 at = pixel.at + sample;
        return intersect(Ray{{at.x, at.y, -1}, {0, 0, 1}}, shape, Interval{}).has_value();
    }
    const Vec3 from(pixel.at.x, 0, 0);
    const Ray ray{from, sample_light(lamp, from, sample) - from};
    const auto t = intersect(ray, screen, Interval{});
    return !t || at(ray, *t).x >= 0;
}

/// The root mean square error in levels with the first 1, 4, … of all rays.
void tell_errors(const char* picture, const std::vector<Known>& pixels, bool spread) {
    std::array<double, 6> squares{};
    std::mt19937_64 generator(1);
    std::uniform_real_distribution<double> uniform;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        int seen = 0;
        std::size_t column = 0;
        for (int count = 1; count <= most; ++count) {
            const Vec2 sample = spread ? spread_sample(std::uint32_t(count - 1), std::uint32_t(i))
                                       : Vec2(uniform(generator), uniform(generator));
            seen += is_seen(picture, pixels[i], sample);
            if (count != 1 << 2 * column) continue;
            const double error = 255 * (double(seen) / count - pixels[i].truth);
            squares[column++] += error * error;
        }
    }
    for (std::size_t column = 0; column < squares.size(); ++column)
        std::printf("%s,%s,%d,%.4g\n", picture, spread ? "well spread" : "independent",
                    1 << 2 * column, std::sqrt(squares[column] / double(pixels.size())));
}

/// The root mean square over the edge of a change of the truth, in levels.
template <class Change>
void tell_change(const char* what, const std::vector<Known>& edge, Change change) {
    double squares = 0;
    for (const Known& pixel : edge) squares += std::pow(255 * change(pixel.truth), 2);
    std::printf("%s,,1,%.4g\n", what, std::sqrt(squares / double(edge.size())));
}

/// The contrast that stripes of the given period in pixels keep, of 255, with the pixel filters.
void tell_filters(const char* name, double (*kept)(double frequency)) {
    for (const double period : {4.0, 1.25})
        std::printf("filter %s,,%.4g,%.4g\n", name, period, 255 * std::abs(kept(1 / period)));
}

void tell_shading(const char* precision, const ShadedSphere& off) {
    std::printf("sphere's inside in %s,,1,%.4g\nsphere's silhouette in %s,,1,%.4g\n", precision,
                off.inside, precision, off.silhouette);
}

double sinc(double x) {
    return std::sin(pi * x) / (pi * x);
}

}  // namespace

int main() {
    std::vector<Known> edge;
    for (int i = 0; i < width * height; ++i)
        edge.push_back({covered(Vec2(i % width, i / width)), Vec2(i % width, i / width)});
    std::vector<Known> penumbra;
    for (int i = 0; i < 1000; ++i)
        penumbra.push_back({visible(-2 + 0.004 * (i + 0.5)), Vec2(-2 + 0.004 * (i + 0.5), 0)});
    const auto is_plain = [](const Known& pixel) {
        return pixel.truth < 1e-12 || pixel.truth > 1 - 1e-12;
    };
    std::erase_if(edge, is_plain);
    std::erase_if(penumbra, is_plain);
    std::puts("picture,rays are,rays,error");
    for (const bool spread : {false, true}) tell_errors("edge", edge, spread);
    for (const bool spread : {false, true}) tell_errors("penumbra", penumbra, spread);
    tell_change("8 bits", edge, [](double v) { return std::round(255 * v) / 255 - v; });
    tell_change("mean of encoded", edge, [](double v) { return encoded(v, Gamma::srgb) - v; });
    tell_change("clamped after", edge, [](double v) { return std::min(4 * v, 1.0) - v; });
    tell_filters("box", [](double f) { return sinc(f); });
    tell_filters("tent", [](double f) { return sinc(f) * sinc(f); });
    tell_filters("Gauss", [](double f) { return std::exp(-pi * pi * f * f / 2); });
    tell_shading("float", f32::shaded_sphere());
    tell_shading("double", f64::shaded_sphere());
    std::printf("chain of mirrors,,8,%.4g\n", 255 * std::pow(0.8, 9));
}
