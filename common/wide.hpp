// Four numbers at a time, as one instruction takes them (GCC's and Clang's vector extensions), or
// one after the other where the compiler has none: the same bits either way.
#pragma once

#include "common/real.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <type_traits>

#ifdef __SSE2__
#include <immintrin.h>
#endif

// Which of the two. What holds lanes lives in this inline namespace, so that a suite can compile
// the other form beside the one that programs use.
#ifndef RT_LANES
#ifdef __GNUC__
#define RT_LANES vector_lanes
#else
#define RT_LANES scalar_lanes
#endif
#endif

namespace rt::inline RT_PRECISION {

/// What four lanes are made of: one number, or the 16 bytes that every machine's vectors hold.
namespace lane_parts {
template <class Number>
struct scalar_lanes {
    using Part = Number;
    using Mask = int;
};
#ifdef __GNUC__
template <class Number>
struct vector_lanes {
    typedef Number Part __attribute__((vector_size(16)));
    using Mask = decltype(Part{} < Part{});
};
#endif
}  // namespace lane_parts

inline namespace RT_LANES {

template <class Number>
using LanePart = typename lane_parts::RT_LANES<Number>::Part;
template <class Number>
using LaneMask = typename lane_parts::RT_LANES<Number>::Mask;

inline constexpr std::size_t lane_count = 4;
template <class Number>
inline constexpr std::size_t lane_part_count = lane_count * sizeof(Number) /
                                               sizeof(LanePart<Number>);

/// op(0), op(1), … for every part. Written out: a loop over two parts would keep them in memory.
template <class Number, template <class> class Result, class Op>
[[nodiscard]] inline Result<Number> each_part(Op op) {
    if constexpr (lane_part_count<Number> == 1) return {{op(0)}};
    if constexpr (lane_part_count<Number> == 2) return {{op(0), op(1)}};
    if constexpr (lane_part_count<Number> == 4) return {{op(0), op(1), op(2), op(3)}};
}

/// What a comparison says of each lane.
template <class Number>
struct MaskOf {
    std::array<LaneMask<Number>, lane_part_count<Number>> parts;
};

/// Four numbers that every operation treats alike.
template <class Number>
struct alignas(16) LanesOf {
    std::array<LanePart<Number>, lane_part_count<Number>> parts;
};

using Lanes = LanesOf<Real>;
using Floats = LanesOf<float>;  ///< in either precision

/// The same number four times.
[[nodiscard]] inline Lanes all_lanes(Real value) {
    return each_part<Real, LanesOf>([value](std::size_t) { return value - LanePart<Real>{}; });
}

[[nodiscard]] inline Floats all_floats(float value) {
    return each_part<float, LanesOf>([value](std::size_t) { return value - LanePart<float>{}; });
}

[[nodiscard]] inline Floats floats_of(const std::array<float, lane_count>& values) {
    return std::bit_cast<Floats>(values);
}

template <class Number>
[[nodiscard]] inline std::array<Number, lane_count> values(LanesOf<Number> lanes) {
    return std::bit_cast<std::array<Number, lane_count>>(lanes);
}

template <class Number>
[[nodiscard]] inline LanesOf<Number> operator+(LanesOf<Number> a, LanesOf<Number> b) {
    return each_part<Number, LanesOf>([&](std::size_t i) { return a.parts[i] + b.parts[i]; });
}

template <class Number>
[[nodiscard]] inline LanesOf<Number> operator-(LanesOf<Number> a, LanesOf<Number> b) {
    return each_part<Number, LanesOf>([&](std::size_t i) { return a.parts[i] - b.parts[i]; });
}

template <class Number>
[[nodiscard]] inline LanesOf<Number> operator*(LanesOf<Number> a, LanesOf<Number> b) {
    return each_part<Number, LanesOf>([&](std::size_t i) { return a.parts[i] * b.parts[i]; });
}

template <class Number>
[[nodiscard]] inline LanesOf<Number> operator/(LanesOf<Number> a, LanesOf<Number> b) {
    return each_part<Number, LanesOf>([&](std::size_t i) { return a.parts[i] / b.parts[i]; });
}

/// The smaller of each pair; b's, where either is NaN.
template <class Number>
[[nodiscard]] inline LanesOf<Number> min(LanesOf<Number> a, LanesOf<Number> b) {
    return each_part<Number, LanesOf>(
        [&](std::size_t i) { return a.parts[i] < b.parts[i] ? a.parts[i] : b.parts[i]; });
}

/// The larger of each pair; b's, where either is NaN.
template <class Number>
[[nodiscard]] inline LanesOf<Number> max(LanesOf<Number> a, LanesOf<Number> b) {
    return each_part<Number, LanesOf>(
        [&](std::size_t i) { return a.parts[i] > b.parts[i] ? a.parts[i] : b.parts[i]; });
}

template <class Number>
[[nodiscard]] inline MaskOf<Number> operator<(LanesOf<Number> a, LanesOf<Number> b) {
    return each_part<Number, MaskOf>([&](std::size_t i) { return a.parts[i] < b.parts[i]; });
}

template <class Number>
[[nodiscard]] inline MaskOf<Number> operator<=(LanesOf<Number> a, LanesOf<Number> b) {
    return each_part<Number, MaskOf>([&](std::size_t i) { return a.parts[i] <= b.parts[i]; });
}

template <class Number>
[[nodiscard]] inline MaskOf<Number> operator&(MaskOf<Number> a, MaskOf<Number> b) {
    return each_part<Number, MaskOf>(
        [&](std::size_t i) { return LaneMask<Number>(a.parts[i] & b.parts[i]); });
}

template <class Number>
[[nodiscard]] inline MaskOf<Number> operator|(MaskOf<Number> a, MaskOf<Number> b) {
    return each_part<Number, MaskOf>(
        [&](std::size_t i) { return LaneMask<Number>(a.parts[i] | b.parts[i]); });
}

/// One bit a lane, the first lane's lowest.
[[nodiscard]] inline unsigned bits(const std::array<int, lane_count>& lanes) {
    unsigned result = 0;
    for (std::size_t i = 0; i < lane_count; ++i) result |= unsigned(lanes[i]) << i;
    return result;
}

#ifdef __SSE2__
[[nodiscard]] inline unsigned sign_bits(__m128 part) {
    return unsigned(_mm_movemask_ps(part));
}

[[nodiscard]] inline unsigned sign_bits(__m128d part) {
    return unsigned(_mm_movemask_pd(part));
}
#endif

template <class Number>
[[nodiscard]] inline unsigned bits(MaskOf<Number> mask) {
    if constexpr (std::is_same_v<LaneMask<Number>, int>) {
        return bits(mask.parts);
    } else {
        unsigned result = 0;
#ifdef __SSE2__
        for (std::size_t i = 0; i < mask.parts.size(); ++i)
            result |= sign_bits(std::bit_cast<LanePart<Number>>(mask.parts[i]))
                      << (i * lane_count / mask.parts.size());
#else
        using Word = std::conditional_t<sizeof(Number) == 4, std::uint32_t, std::uint64_t>;
        const auto words = std::bit_cast<std::array<Word, lane_count>>(mask.parts);
        for (std::size_t i = 0; i < lane_count; ++i) result |= unsigned(words[i] & 1) << i;
#endif
        return result;
    }
}

}  // namespace RT_LANES

}  // namespace rt::inline RT_PRECISION
