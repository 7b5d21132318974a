// attack: compiles almost as long as it may, before an error that lets it be compiled again
// ceiling: as a stub
// compiles: no
// processor: 22
#include "steps/step03_sphere/sphere.hpp"

// Small numbers, which the compiler keeps: it needs time for them, and no memory.
constexpr unsigned spin(unsigned number) {
    unsigned sum = number % 250;
    for (unsigned i = 0; i < 250; ++i)
        for (unsigned j = 0; j < 250; ++j)
            for (unsigned k = 0; k < 4; ++k) sum = (sum + k) % 250;
    return sum;
}

template <unsigned number>
struct Sum {
    static constexpr unsigned value = spin(number) + Sum<number - 1>::value;
};

template <>
struct Sum<0> {
    static constexpr unsigned value = 0;
};

static_assert(Sum<75>::value == 0);
