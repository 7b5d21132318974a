// The cost of each form, for rays that hit and rays that miss: one turn, of which `course measure`
// runs several, one precision at a time.
#include "tests/measurements/accuracy/forms.hpp"
#include "tests/stability/sweeps.hpp"

#include <algorithm>
#include <cstdio>
#include <ctime>

using namespace rt;

namespace {

constexpr int rays = 4096;  // too many for branch prediction to memorize
constexpr int passes = 4;   // over all of them at a time
constexpr int turns = 9;    // the median counts

/// The processor's: on a machine that others use, the clock's has their turns in it.
template <class Shape>
double seconds_for(const Form<Shape>& form, const std::vector<Case<Shape>>& cases) {
    Real sum = 0;  // keeps the compiler from removing code
    const std::clock_t start = std::clock();
    for (int pass = 0; pass < passes; ++pass)
        for (const Case<Shape>& each : cases)
            sum += form.intersect(each.ray, each.shape, {}).value_or(0);
    const std::clock_t taken = std::clock() - start;
    volatile Real kept = sum;
    (void)kept;
    return double(taken) / CLOCKS_PER_SEC;
}

/// Ordinary rays, all of which hit, or all of which miss, according to the reference.
template <class Shape>
std::vector<Case<Shape>> cases_that(bool hit, const Form<Shape>& reference) {
    Random random(1);
    std::vector<Case<Shape>> cases;
    while (cases.size() < rays) {
        Case<Shape> random_case;
        draw(random, Sweep::moderate, random_case);
        if (reference.intersect(random_case.ray, random_case.shape, {}).has_value() == hit)
            cases.push_back(random_case);
    }
    return cases;
}

template <class Shape>
void measure(const char* name, const Shape& shape, bool hit) {
    const auto forms = forms_of(shape);
    const std::vector<Case<Shape>> cases = cases_that<Shape>(hit, forms.front());
    std::vector<std::vector<double>> times(forms.size());
    for (int turn = 0; turn < turns; ++turn)
        for (std::size_t i = 0; i < forms.size(); ++i)
            times[i].push_back(seconds_for(forms[i], cases));
    for (std::size_t i = 0; i < forms.size(); ++i) {
        const auto middle = times[i].begin() + turns / 2;
        std::ranges::nth_element(times[i], middle);
        std::printf("%s,%s,%s,%s,%.3f\n", name, forms[i].name, forms[i].precision,
                    hit ? "hit" : "miss", 1e9 * *middle / rays / passes);
    }
}

}  // namespace

int main() {
    std::puts("shape,form,precision,rays,nanoseconds");
    for_every_shape([](const char* name, const auto& shape) {
        for (const bool hit : {true, false}) measure(name, shape, hit);
    });
}
