// SIMD: four or eight numbers in one instruction (GCC's and Clang's vector extensions), or one
// after the other on a compiler without them. The results have the same bits either way.
#pragma once

#include "common/math/real.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

// Selects the SIMD backend. Every type that contains lanes is in an inline namespace named after
// it, so that objects compiled for different processors link into one program: a suite compares the
// backends, and the archives of a hand-out are for any processor.
#ifndef RT_LANES
#if !defined(__GNUC__)
#define RT_LANES scalar_lanes
#elif !defined(__AVX__)
#define RT_LANES vector_lanes
#else
#define RT_LANES long_vector_lanes
#endif
#endif

namespace rt {
inline namespace RT_PRECISION {

/// The unit of the lanes in each backend: a single number, a vector of the 16 bytes that every
/// machine supports, or one of 32.
namespace lane_parts {
template <class Number, std::size_t count>
struct scalar_lanes {
    using Part = Number;
    using Mask = int;
};
#ifdef __GNUC__
template <class Number, std::size_t count>
struct vector_lanes {
    static constexpr std::size_t size = std::min(count * sizeof(Number), std::size_t(16));
    typedef Number Part __attribute__((vector_size(size)));
    using Mask = decltype(Part{} < Part{});
};
template <class Number, std::size_t count>
struct long_vector_lanes {
    static constexpr std::size_t size = std::min(count * sizeof(Number), std::size_t(32));
    typedef Number Part __attribute__((vector_size(size)));
    using Mask = decltype(Part{} < Part{});
};
#endif
}  // namespace lane_parts

inline namespace RT_LANES {

template <class Number, std::size_t count>
using LanePart = typename lane_parts::RT_LANES<Number, count>::Part;
template <class Number, std::size_t count>
using LaneMask = typename lane_parts::RT_LANES<Number, count>::Mask;

template <class Number, std::size_t count>
inline constexpr std::size_t lane_part_count = count * sizeof(Number) /
                                               sizeof(LanePart<Number, count>);

/// Returns op(0), op(1), … for all parts. Unrolled by hand: a loop over two parts would keep them
/// in memory.
template <class Number, std::size_t count, template <class, std::size_t> class Result, class Op>
[[nodiscard]] inline Result<Number, count> each_part(Op op) {
    constexpr std::size_t parts = lane_part_count<Number, count>;
    static_assert(parts == 1 || parts == 2 || parts == 4);
    if constexpr (parts == 1) return {{op(0)}};
    if constexpr (parts == 2) return {{op(0), op(1)}};
    if constexpr (parts == 4) return {{op(0), op(1), op(2), op(3)}};
}

/// The numbers of a part in another type.
template <class To, class From>
[[nodiscard]] inline To converted(From part) {
#ifdef __GNUC__
#if defined(__AVX__) && __has_builtin(__builtin_ia32_cvtps2pd256)
    // One instruction, for which g++ needs seven: it converts each half.
    if constexpr (sizeof(To) == 32 && sizeof(From) == 16)
        return To(__builtin_ia32_cvtps2pd256(part));
    else
#endif
        if constexpr (!std::is_arithmetic_v<From>)
        return __builtin_convertvector(part, To);
    else
#endif
        return To(part);
}

/// The result of a comparison in each lane.
template <class Number, std::size_t count>
struct MaskOf {
    std::array<LaneMask<Number, count>, lane_part_count<Number, count>> parts;
};

/// A vector of numbers; every operation applies to each lane.
template <class Number, std::size_t count>
struct alignas(count * sizeof(Number)) LanesOf {
    std::array<LanePart<Number, count>, lane_part_count<Number, count>> parts;
};

inline constexpr std::size_t lane_count = 4;
/// The number of floats in one instruction: eight if it has room for them, else four.
inline constexpr std::size_t float_count =
    std::max(lane_count, sizeof(LanePart<float, 8>) / sizeof(float));

/// The number of Reals in one instruction: eight floats if it has room for them, else four.
inline constexpr std::size_t real_count =
    std::max(lane_count, sizeof(LanePart<Real, 8>) / sizeof(Real));

using RealX4 = LanesOf<Real, lane_count>;
using RealN = LanesOf<Real, real_count>;
using Float4 = LanesOf<float, lane_count>;  ///< in either precision
using FloatN = LanesOf<float, float_count>;

/// The same number in every lane.
template <class Number, std::size_t count>
[[nodiscard]] inline LanesOf<Number, count> all_of(Number value) {
    return each_part<Number, count, LanesOf>(
        [value](std::size_t) { return value - LanePart<Number, count>{}; });
}

[[nodiscard]] inline RealX4 broadcast(Real value) {
    return all_of<Real, lane_count>(value);
}

[[nodiscard]] inline Float4 broadcast_float(float value) {
    return all_of<float, lane_count>(value);
}

/// Four numbers. A vector of each part: g++ would assemble an array in two other registers.
template <class Number>
[[nodiscard]] inline LanesOf<Number, 4> lanes_of(Number a, Number b, Number c, Number d) {
    using Part = LanePart<Number, 4>;
    constexpr std::size_t parts = lane_part_count<Number, 4>;
    if constexpr (parts == 1) return {{Part{a, b, c, d}}};
    if constexpr (parts == 2) return {{Part{a, b}, Part{c, d}}};
    if constexpr (parts == 4) return {{a, b, c, d}};
}

template <class Number, std::size_t count>
[[nodiscard]] inline std::array<Number, count> values(LanesOf<Number, count> lanes) {
    return std::bit_cast<std::array<Number, count>>(lanes);
}

/// One of the numbers; g++ would store all of them again for `values`.
template <class Number, std::size_t count>
[[nodiscard]] inline Number lane(const LanesOf<Number, count>& lanes, std::size_t i) {
    Number value;
    std::memcpy(&value, reinterpret_cast<const std::byte*>(&lanes) + i * sizeof value,
                sizeof value);
    return value;
}

template <class Number, std::size_t count>
inline void set_lane(LanesOf<Number, count>& lanes, std::size_t i, Number value) {
    std::memcpy(reinterpret_cast<std::byte*>(&lanes) + i * sizeof value, &value, sizeof value);
}

template <class Number, std::size_t count>
[[nodiscard]] inline LanesOf<Number, count> operator+(LanesOf<Number, count> a,
                                                      LanesOf<Number, count> b) {
    return each_part<Number, count, LanesOf>(
        [&](std::size_t i) { return a.parts[i] + b.parts[i]; });
}

template <class Number, std::size_t count>
[[nodiscard]] inline LanesOf<Number, count> operator-(LanesOf<Number, count> a,
                                                      LanesOf<Number, count> b) {
    return each_part<Number, count, LanesOf>(
        [&](std::size_t i) { return a.parts[i] - b.parts[i]; });
}

template <class Number, std::size_t count>
[[nodiscard]] inline LanesOf<Number, count> operator*(LanesOf<Number, count> a,
                                                      LanesOf<Number, count> b) {
    return each_part<Number, count, LanesOf>(
        [&](std::size_t i) { return a.parts[i] * b.parts[i]; });
}

template <class Number, std::size_t count>
[[nodiscard]] inline LanesOf<Number, count> operator/(LanesOf<Number, count> a,
                                                      LanesOf<Number, count> b) {
    return each_part<Number, count, LanesOf>(
        [&](std::size_t i) { return a.parts[i] / b.parts[i]; });
}

/// a · b + c, rounded once where the processor has an instruction for it, else twice.
template <std::size_t count>
[[nodiscard]] inline LanesOf<float, count> multiply_add(LanesOf<float, count> a,
                                                        LanesOf<float, count> b,
                                                        LanesOf<float, count> c) {
    return each_part<float, count, LanesOf>([&](std::size_t i) {
#ifdef __FMA__
        using Part = LanePart<float, count>;
        if constexpr (sizeof(Part) == 32)
            return Part(__builtin_ia32_vfmaddps256(a.parts[i], b.parts[i], c.parts[i]));
        else if constexpr (sizeof(Part) == 16)
            return Part(__builtin_ia32_vfmaddps(a.parts[i], b.parts[i], c.parts[i]));
        else
#endif
            return a.parts[i] * b.parts[i] + c.parts[i];
    });
}

/// The same numbers as Real.
template <class Number>
[[nodiscard]] inline RealN real_of(LanesOf<Number, real_count> lanes) {
    constexpr std::size_t count = lane_part_count<Real, real_count>;
    using Part = LanePart<Number, real_count / count>;
    const auto parts = std::bit_cast<std::array<Part, count>>(lanes);
    return each_part<Real, real_count, LanesOf>(
        [&](std::size_t i) { return converted<LanePart<Real, real_count>>(parts[i]); });
}

template <class Part>
[[nodiscard]] inline Part lesser(Part a, Part b) {
    return a < b ? a : b;
}

template <class Part>
[[nodiscard]] inline Part greater(Part a, Part b) {
    return a > b ? a : b;
}

// The same in one instruction, which g++ does not find for a constant.
#ifdef __SSE2__
[[nodiscard]] inline auto lesser(lane_parts::vector_lanes<float, 4>::Part a,
                                 lane_parts::vector_lanes<float, 4>::Part b) {
    return __builtin_ia32_minps(a, b);
}

[[nodiscard]] inline auto greater(lane_parts::vector_lanes<float, 4>::Part a,
                                  lane_parts::vector_lanes<float, 4>::Part b) {
    return __builtin_ia32_maxps(a, b);
}
#endif

#ifdef __AVX__
[[nodiscard]] inline auto greater(lane_parts::long_vector_lanes<float, 8>::Part a,
                                  lane_parts::long_vector_lanes<float, 8>::Part b) {
    return __builtin_ia32_maxps256(a, b);
}
#endif

/// The smaller of each pair; b's, where either is NaN.
template <class Number, std::size_t count>
[[nodiscard]] inline LanesOf<Number, count> min(LanesOf<Number, count> a,
                                                LanesOf<Number, count> b) {
    return each_part<Number, count, LanesOf>(
        [&](std::size_t i) { return lesser(a.parts[i], b.parts[i]); });
}

/// The larger of each pair; b's, where either is NaN.
template <class Number, std::size_t count>
[[nodiscard]] inline LanesOf<Number, count> max(LanesOf<Number, count> a,
                                                LanesOf<Number, count> b) {
    return each_part<Number, count, LanesOf>(
        [&](std::size_t i) { return greater(a.parts[i], b.parts[i]); });
}

template <class Number, std::size_t count>
[[nodiscard]] inline MaskOf<Number, count> operator<(LanesOf<Number, count> a,
                                                     LanesOf<Number, count> b) {
    return each_part<Number, count, MaskOf>([&](std::size_t i) { return a.parts[i] < b.parts[i]; });
}

template <class Number, std::size_t count>
[[nodiscard]] inline MaskOf<Number, count> operator<=(LanesOf<Number, count> a,
                                                      LanesOf<Number, count> b) {
    return each_part<Number, count, MaskOf>(
        [&](std::size_t i) { return a.parts[i] <= b.parts[i]; });
}

template <class Number, std::size_t count>
[[nodiscard]] inline MaskOf<Number, count> operator&(MaskOf<Number, count> a,
                                                     MaskOf<Number, count> b) {
    return each_part<Number, count, MaskOf>(
        [&](std::size_t i) { return LaneMask<Number, count>(a.parts[i] & b.parts[i]); });
}

template <class Number, std::size_t count>
[[nodiscard]] inline MaskOf<Number, count> operator|(MaskOf<Number, count> a,
                                                     MaskOf<Number, count> b) {
    return each_part<Number, count, MaskOf>(
        [&](std::size_t i) { return LaneMask<Number, count>(a.parts[i] | b.parts[i]); });
}

/// Requests an object that is read soon, up to four cache lines of it: the processor fetches them
/// from memory while it does other work.
template <class T>
[[gnu::always_inline]] inline void prefetch([[maybe_unused]] const T& object) {
#ifdef __GNUC__
    const auto* bytes = reinterpret_cast<const std::byte*>(&object);
    __builtin_prefetch(bytes);  // not in a loop, which g++ does not unroll
    if constexpr (sizeof object > 64) __builtin_prefetch(bytes + 64);
    if constexpr (sizeof object > 128) __builtin_prefetch(bytes + 128);
    if constexpr (sizeof object > 192) __builtin_prefetch(bytes + 192);
    asm volatile("");  // g++ removes calls of a function that only prefetches
#endif
}

/// One bit for each lane; the first lane's is the lowest.
template <std::size_t count>
[[nodiscard]] inline unsigned mask_bits(const std::array<int, count>& lanes) {
    unsigned result = 0;
    for (std::size_t i = 0; i < count; ++i) result |= unsigned(lanes[i]) << i;
    return result;
}

// These are the compilers' own functions: <immintrin.h>, which gives them other names, would add
// 0.3 s to the compile of every file that reads a scene.
#ifdef __SSE2__
[[nodiscard]] inline unsigned sign_bits(lane_parts::vector_lanes<float, 4>::Part part) {
    return unsigned(__builtin_ia32_movmskps(part));
}

[[nodiscard]] inline unsigned sign_bits(lane_parts::vector_lanes<double, 2>::Part part) {
    return unsigned(__builtin_ia32_movmskpd(part));
}
#endif

#ifdef __AVX__
[[nodiscard]] inline unsigned sign_bits(lane_parts::long_vector_lanes<float, 8>::Part part) {
    return unsigned(__builtin_ia32_movmskps256(part));
}

[[nodiscard]] inline unsigned sign_bits(lane_parts::long_vector_lanes<double, 4>::Part part) {
    return unsigned(__builtin_ia32_movmskpd256(part));
}
#endif

template <class Number, std::size_t count>
[[nodiscard]] inline unsigned mask_bits(MaskOf<Number, count> mask) {
    if constexpr (std::is_same_v<LaneMask<Number, count>, int>) {
        return mask_bits(mask.parts);
    } else {
        unsigned result = 0;
#ifdef __SSE2__
        for (std::size_t i = 0; i < mask.parts.size(); ++i)
            result |= sign_bits(std::bit_cast<LanePart<Number, count>>(mask.parts[i]))
                      << (i * count / mask.parts.size());
#else
        using Word = std::conditional_t<sizeof(Number) == 4, std::uint32_t, std::uint64_t>;
        const auto words = std::bit_cast<std::array<Word, count>>(mask.parts);
        for (std::size_t i = 0; i < count; ++i) result |= unsigned(words[i] & 1) << i;
#endif
        return result;
    }
}

/// Clears the lowest set bit, and returns its index.
template <std::unsigned_integral Bits>
[[nodiscard]] inline std::size_t pop_lowest_bit(Bits& bits) {
    const auto lowest = std::size_t(std::countr_zero(bits));
    bits &= bits - 1;
    return lowest;
}

}  // namespace RT_LANES

}  // namespace RT_PRECISION
}  // namespace rt
