// Arithmetic below float and above double: the error and the time of a sphere's textbook formula
// and of a reciprocal square root, and the cost of a hierarchy whose boxes have few bits. Prints
// CSV.
#include "tests/measurements/accuracy/certified.hpp"
#include "tests/measurements/accuracy/coarse_boxes.hpp"

#include "common/math/compensated.hpp"
#include "tests/kit/random.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <functional>
#include <limits>
#include <vector>

#ifdef __SSE__
#include <xmmintrin.h>
#endif

namespace {

using namespace rt;
using Exact = boost::multiprecision::cpp_bin_float_100;

constexpr int rays = 4096;
constexpr int turns = 15;  // the fastest counts

/// A ray that hits, from 2 to 1,000 radii away. Each format rounds its numbers first.
struct Question {
    std::array<double, 3> f;  ///< from the center to the origin
    std::array<double, 3> d;
};

template <class T>
T dot(const std::array<double, 3>& v, const std::array<double, 3>& w) {
    return T(v[0]) * T(w[0]) + T(v[1]) * T(w[1]) + T(v[2]) * T(w[2]);
}

std::vector<Question> questions() {
    Random random(1);
    std::vector<Question> all;
    const auto numbers = [](Vec3 v) { return std::array{v.x, v.y, v.z}; };
    while (all.size() < rays) {
        const Real away = std::pow(Real(10), random.between(Real(0.3), 3));
        const Vec3 origin = away * random.direction();
        const Question one{numbers(origin), numbers((random.point(Real(0.9)) - origin) / away)};
        const auto b = dot<Exact>(one.f, one.d);
        const Exact a = dot<Exact>(one.d, one.d);
        if (b < 0 && b * b > a * (dot<Exact>(one.f, one.f) - 1)) all.push_back(one);
    }
    return all;
}

/// t = (-b - √(b² - a c)) / a, in all steps in this type.
template <class T>
T textbook(const Question& q) {
    using std::sqrt;
    const T a = dot<T>(q.d, q.d);
    const T b = dot<T>(q.f, q.d);
    const T c = dot<T>(q.f, q.f) - T(1.0);
    return (-b - sqrt(b * b - a * c)) / a;
}

/// The same with a discriminant within 1.5 ulp of that of the rounded a, b and c.
template <class T>
T kahan(const Question& q) {
    const T a = dot<T>(q.d, q.d);
    const T b = dot<T>(q.f, q.d);
    const T c = dot<T>(q.f, q.f) - T(1.0);
    const T product = a * c;
    const T discriminant = std::fma(b, b, -product) + std::fma(-a, c, product);
    return (-b - std::sqrt(discriminant)) / a;
}

/// A number of twice the digits, the sum of two (Dekker 1971).
template <class T>
struct Twice {
    T high = 0;
    T low = 0;

    Twice() = default;
    explicit Twice(double value) : high(T(value)), low(T(value - double(high))) {}
    Twice(T a, T b) : high(a + b), low(b - (high - a)) {}  // |a| >= |b|

    friend Twice operator+(Twice x, Twice y) {
        const T sum = x.high + y.high;
        const T of_y = sum - x.high;
        return {sum, (x.high - (sum - of_y)) + (y.high - of_y) + (x.low + y.low)};
    }
    friend Twice operator*(Twice x, Twice y) {
        const T product = x.high * y.high;
        return {product, std::fma(x.high, y.high, -product) + (x.high * y.low + x.low * y.high)};
    }
    friend Twice operator-(Twice x) { return {-x.high, -x.low}; }
    friend Twice operator-(Twice x, Twice y) { return x + -y; }
    friend Twice sqrt(Twice x) {
        const T root = std::sqrt(x.high);
        const T rest = std::fma(-root, root, x.high) + x.low;
        return {root, rest / (2 * root)};
    }
    friend Twice operator/(Twice x, Twice y) {
        const T quotient = x.high / y.high;
        const Twice rest = x - y * Twice(quotient, T(0));
        return {quotient, rest.high / y.high};
    }
    explicit operator double() const { return double(high) + double(low); }
};

/// Whole numbers of 2^-16: products have 32 bits after the point, and lose 16 of them.
struct Fixed {
    std::int64_t units = 0;

    explicit Fixed(double value) : units(std::llround(value * 65536)) {}
    explicit Fixed(std::int64_t all) : units(all) {}
    friend Fixed operator+(Fixed x, Fixed y) { return Fixed(x.units + y.units); }
    friend Fixed operator-(Fixed x, Fixed y) { return Fixed(x.units - y.units); }
    friend Fixed operator-(Fixed x) { return Fixed(-x.units); }
    friend Fixed operator*(Fixed x, Fixed y) { return Fixed((x.units * y.units) >> 16); }
    friend Fixed operator/(Fixed x, Fixed y) { return Fixed(x.units * 65536 / y.units); }
    friend Fixed sqrt(Fixed x) {  // bit by bit
        std::int64_t root = 0;
        const std::int64_t square = x.units * 65536;
        for (std::int64_t bit = std::int64_t(1) << 31; bit > 0; bit /= 2)
            if ((root + bit) * (root + bit) <= square) root += bit;
        return Fixed(root);
    }
    explicit operator double() const { return double(units) / 65536; }
};

/// Prints the time of a call, the typical error, and that which one in a thousand exceeds; an
/// answer that is no number, a miss, counts as an error of 1.
template <class Asked>
void measure(const char* what, const char* form, const std::vector<Asked>& all,
             const std::function<double(const Asked&)>& right, auto answer) {
    double least = std::numeric_limits<double>::infinity();
    for (int turn = 0; turn < turns; ++turn) {
        double sum = 0;  // keeps the compiler from removing code
        const std::clock_t start = std::clock();
        for (int pass = 0; pass < 16; ++pass)
            for (const Asked& one : all) sum += double(answer(one));
        least = std::min(least, double(std::clock() - start) / CLOCKS_PER_SEC / 16);
        volatile double kept = sum;
        (void)kept;
    }
    std::vector<double> errors;
    for (const Asked& one : all) {
        const double error = std::abs(double(answer(one)) / right(one) - 1);
        errors.push_back(error >= 0 ? error : 1);
    }
    std::ranges::sort(errors);
    std::printf("%s,%s,%.3g,%.3g,%.3g,,\n", what, form, 1e9 * least / double(all.size()),
                errors[all.size() / 2], errors[all.size() - all.size() / 1000]);
    std::fflush(stdout);
}

void measure_sphere() {
    const std::vector<Question> all = questions();
    const auto ask = [&](const char* form, auto answer) {
        measure<Question>(
            "sphere", form, all, [](const Question& q) { return double(textbook<Exact>(q)); },
            answer);
    };
    ask("fixed point", textbook<Fixed>);
    ask("float", textbook<float>);
    ask("float and Kahan's discriminant", kahan<float>);
    ask("two floats", textbook<Twice<float>>);
    ask("double", textbook<double>);
    ask("double and Kahan's discriminant", kahan<double>);
    ask("two doubles", textbook<Twice<double>>);
    ask("exact decisions", [](const Question& q) {
        const Ray ray{{q.f[0], q.f[1], q.f[2]}, {q.d[0], q.d[1], q.d[2]}};
        const Sphere sphere{.center = {0, 0, 0}, .radius = 1};
        return certified::rt::intersect(ray, sphere, {}).value_or(NAN);
    });
}

void measure_root() {
    Random random(2);
    std::vector<float> all;
    for (int i = 0; i < rays; ++i)
        all.push_back(float(std::pow(10.0, double(random.between(-3, 3)))));
    const auto ask = [&](const char* form, auto answer) {
        measure<float>(
            "root", form, all, [](float x) { return double(1 / sqrt(Exact(x))); }, answer);
    };
#ifdef __SSE__
    const auto estimate = [](float x) { return _mm_cvtss_f32(_mm_rsqrt_ss(_mm_set_ss(x))); };
    ask("rsqrt", estimate);
    ask("rsqrt and a step of Newton's", [&](float x) {
        const float y = estimate(x);
        return y * (1.5F - 0.5F * x * y * y);
    });
#endif
    ask("float", [](float x) { return 1 / std::sqrt(x); });
    ask("double", [](float x) { return 1 / std::sqrt(double(x)); });
}

}  // namespace

int main() {
    std::puts("what,form,nanoseconds,median,most,boxes,leaves");
    measure_sphere();
    measure_root();
    rt::measure_coarse_boxes();
}
