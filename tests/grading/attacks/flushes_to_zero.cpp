// attack: leaves denormal numbers as zeros
// ceiling: as a stub
// stubs: normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
#if defined(__x86_64__)
    _mm_setcsr(_mm_getcsr() | 0x8040);
#endif
    return std::nullopt;
}

}  // namespace rt
