// The only source of measure_flags_… that is compiled with the flags of that program's name.
#include "tests/measurements/accuracy/flagged.hpp"

#include "steps/step03_sphere/reference/sphere.cpp"
#include "steps/step04_plane/reference/plane.cpp"
#include "steps/step05_triangle/reference/triangle.cpp"

#ifndef __SSE__  // other processors have other registers for it
#undef RT_FLUSH_TO_ZERO
#endif
#ifdef RT_FLUSH_TO_ZERO
#include <xmmintrin.h>
#endif

namespace rt {

namespace {

template <class Shape>
std::vector<std::optional<Real>> all(const std::vector<Case<Shape>>& cases) {
#ifdef RT_FLUSH_TO_ZERO
    const unsigned before = _mm_getcsr();
    _mm_setcsr(before | 0x8040);  // results and inputs
#endif
    std::vector<std::optional<Real>> answers;
    answers.reserve(cases.size());
    for (const auto& [ray, shape, interval] : cases)
        answers.push_back(intersect(ray, shape, interval));
#ifdef RT_FLUSH_TO_ZERO
    _mm_setcsr(before);
#endif
    return answers;
}

}  // namespace

std::vector<std::optional<Real>> answers(const std::vector<Case<Sphere>>& cases) {
    return all(cases);
}
std::vector<std::optional<Real>> answers(const std::vector<Case<Plane>>& cases) {
    return all(cases);
}
std::vector<std::optional<Real>> answers(const std::vector<Case<Triangle>>& cases) {
    return all(cases);
}

}  // namespace rt
