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
using scalar_lanes = Real;
#ifdef __GNUC__
using vector_lanes = Real __attribute__((vector_size(16)));
#endif
}  // namespace lane_parts

inline namespace RT_LANES {

using LanePart = lane_parts::RT_LANES;
using LaneMask =
    std::conditional_t<std::is_same_v<LanePart, Real>, int, decltype(LanePart{} < LanePart{})>;

inline constexpr std::size_t lane_count = 4;
inline constexpr std::size_t lane_part_count = lane_count * sizeof(Real) / sizeof(LanePart);

/// op(0), op(1), … for every part. Written out: a loop over two parts would keep them in memory.
template <class Result, class Op>
[[nodiscard]] inline Result each_part(Op op) {
    if constexpr (lane_part_count == 1) return Result{{op(0)}};
    if constexpr (lane_part_count == 2) return Result{{op(0), op(1)}};
    if constexpr (lane_part_count == 4) return Result{{op(0), op(1), op(2), op(3)}};
}

/// What a comparison says of each lane.
struct Mask {
    std::array<LaneMask, lane_part_count> parts;
};

/// Four numbers that every operation treats alike.
struct alignas(16) Lanes {
    std::array<LanePart, lane_part_count> parts;
};

/// The same number four times.
[[nodiscard]] inline Lanes all_lanes(Real value) {
    return each_part<Lanes>([value](std::size_t) { return value - LanePart{}; });
}

[[nodiscard]] inline Lanes lanes_of(const std::array<Real, lane_count>& values) {
    return std::bit_cast<Lanes>(values);
}

[[nodiscard]] inline std::array<Real, lane_count> values(Lanes lanes) {
    return std::bit_cast<std::array<Real, lane_count>>(lanes);
}

[[nodiscard]] inline Lanes operator+(Lanes a, Lanes b) {
    return each_part<Lanes>([&](std::size_t i) { return a.parts[i] + b.parts[i]; });
}

[[nodiscard]] inline Lanes operator-(Lanes a, Lanes b) {
    return each_part<Lanes>([&](std::size_t i) { return a.parts[i] - b.parts[i]; });
}

[[nodiscard]] inline Lanes operator*(Lanes a, Lanes b) {
    return each_part<Lanes>([&](std::size_t i) { return a.parts[i] * b.parts[i]; });
}

[[nodiscard]] inline Lanes operator/(Lanes a, Lanes b) {
    return each_part<Lanes>([&](std::size_t i) { return a.parts[i] / b.parts[i]; });
}

/// The smaller of each pair; b's, where either is NaN.
[[nodiscard]] inline Lanes min(Lanes a, Lanes b) {
    return each_part<Lanes>(
        [&](std::size_t i) { return a.parts[i] < b.parts[i] ? a.parts[i] : b.parts[i]; });
}

/// The larger of each pair; b's, where either is NaN.
[[nodiscard]] inline Lanes max(Lanes a, Lanes b) {
    return each_part<Lanes>(
        [&](std::size_t i) { return a.parts[i] > b.parts[i] ? a.parts[i] : b.parts[i]; });
}

[[nodiscard]] inline Mask operator<(Lanes a, Lanes b) {
    return each_part<Mask>([&](std::size_t i) { return a.parts[i] < b.parts[i]; });
}

[[nodiscard]] inline Mask operator<=(Lanes a, Lanes b) {
    return each_part<Mask>([&](std::size_t i) { return a.parts[i] <= b.parts[i]; });
}

[[nodiscard]] inline Mask operator&(Mask a, Mask b) {
    return each_part<Mask>([&](std::size_t i) { return LaneMask(a.parts[i] & b.parts[i]); });
}

[[nodiscard]] inline Mask operator|(Mask a, Mask b) {
    return each_part<Mask>([&](std::size_t i) { return LaneMask(a.parts[i] | b.parts[i]); });
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

template <class Part>
[[nodiscard]] inline unsigned bits(const std::array<Part, lane_part_count>& parts) {
    unsigned result = 0;
#ifdef __SSE2__
    for (std::size_t i = 0; i < lane_part_count; ++i)
        result |= sign_bits(std::bit_cast<LanePart>(parts[i]))
                  << (i * lane_count / lane_part_count);
#else
    using Word = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;
    const auto words = std::bit_cast<std::array<Word, lane_count>>(parts);
    for (std::size_t i = 0; i < lane_count; ++i) result |= unsigned(words[i] & 1) << i;
#endif
    return result;
}

[[nodiscard]] inline unsigned bits(Mask mask) {
    return bits(mask.parts);
}

}  // namespace RT_LANES

}  // namespace rt::inline RT_PRECISION
