// What each form costs: one turn, of which `course measure` takes several, a precision at a time.
#include "tests/measurements/accuracy/forms.hpp"
#include "tests/stability/sweeps.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>

using namespace rt;

namespace {

constexpr int rays = 4096;  // too many for the processor to know them by heart
constexpr int passes = 4;   // over all of them at a time
constexpr int turns = 25;   // of which the median counts

template <class Shape>
double seconds_for(const Form<Shape>& form, const std::vector<Case<Shape>>& cases) {
    Real sum = 0;  // so that nothing is left out
    const auto start = std::chrono::steady_clock::now();
    for (int pass = 0; pass < passes; ++pass)
        for (const Case<Shape>& each : cases)
            sum += form.intersect(each.ray, each.shape, {}).value_or(0);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    volatile Real kept = sum;
    (void)kept;
    return taken.count();
}

template <class Shape>
void measure(const char* name, const Shape& shape) {
    Random random(1);
    std::vector<Case<Shape>> cases(rays);
    for (Case<Shape>& each : cases) draw(random, Sweep::moderate, each);
    const auto forms = forms_of(shape);
    std::vector<std::vector<double>> times(forms.size());
    for (int turn = 0; turn < turns; ++turn)
        for (std::size_t i = 0; i < forms.size(); ++i)
            times[i].push_back(seconds_for(forms[i], cases));
    for (std::size_t i = 0; i < forms.size(); ++i) {
        const auto middle = times[i].begin() + turns / 2;
        std::ranges::nth_element(times[i], middle);
        std::printf("%s,%s,%s,%.3f\n", name, forms[i].name, forms[i].precision,
                    1e9 * *middle / rays / passes);
    }
}

}  // namespace

int main() {
    std::puts("shape,form,precision,nanoseconds");
    for_every_shape([](const char* name, const auto& shape) { measure(name, shape); });
}
