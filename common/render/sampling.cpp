#include "common/render/sampling.hpp"

#include "common/system/hash.hpp"

namespace rt {

namespace {

std::uint32_t reversed(std::uint32_t bits) {
    bits = (bits << 16) | (bits >> 16);
    bits = ((bits & 0x00ff00ffU) << 8) | ((bits & 0xff00ff00U) >> 8);
    bits = ((bits & 0x0f0f0f0fU) << 4) | ((bits & 0xf0f0f0f0U) >> 4);
    bits = ((bits & 0x33333333U) << 2) | ((bits & 0xccccccccU) >> 2);
    return ((bits & 0x55555555U) << 1) | ((bits & 0xaaaaaaaaU) >> 1);
}

/// Flips each bit or not, depending on the seed and the bits below it (Burley 2020, after Laine and
/// Karras 2011): Owen's scrambling of the bit-reversed number.
std::uint32_t flipped(std::uint32_t bits, std::uint32_t seed) {
    bits += seed;
    bits ^= bits * 0x6c50b47cU;
    bits ^= bits * 0xb82f1e52U;
    bits ^= bits * 0xc7afe638U;
    bits ^= bits * 0x8d22f6e6U;
    return bits;
}

/// The second dimension of Sobol's sequence, bit-reversed. The bits of the index are the
/// coefficients of a polynomial modulo 2, in which x becomes x + 1: Sobol's matrix is Pascal's
/// triangle. As (x + 1)^k = x^k + 1 for k = 1, 2, 4, …, the upper halves are added to the lower.
std::uint32_t sobol_second(std::uint32_t bits) {
    bits ^= (bits & 0xaaaaaaaaU) >> 1;
    bits ^= (bits & 0xccccccccU) >> 2;
    bits ^= (bits & 0xf0f0f0f0U) >> 4;
    bits ^= (bits & 0xff00ff00U) >> 8;
    return bits ^ (bits >> 16);
}

/// 24 bits, which float represents exactly, so that both precisions use the same points.
Real to_unit_interval(std::uint32_t bits) {
    return Real(bits >> 8) / Real(1U << 24);
}

}  // namespace

Vec2 RT_PRECISION::spread_sample(std::uint32_t index, std::uint32_t seed) {
    const std::uint32_t first =
        reversed(flipped(index, seed));  // the first dimension is the bit-reversed index
    const std::uint32_t second = reversed(flipped(sobol_second(index), mixed_bits(seed)));
    return {to_unit_interval(first), to_unit_interval(second)};
}

std::uint32_t RT_PRECISION::shuffled(std::uint32_t index, std::uint32_t seed) {
    return reversed(flipped(reversed(index), seed));
}

std::uint32_t RT_PRECISION::sample_seed(Pixel pixel, std::uint32_t light, std::uint32_t bounce) {
    std::uint32_t seed = mixed_bits(std::uint32_t(pixel.row) + 1);
    seed = mixed_bits(seed ^ (std::uint32_t(pixel.column) + 1));
    seed = mixed_bits(seed ^ (light + 1));
    return mixed_bits(seed ^ (bounce + 1));
}

}  // namespace rt
