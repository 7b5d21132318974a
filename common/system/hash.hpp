// Hashes that are the same on every machine. Two values with the same hash are easy to find;
// against an attacker, use keyed_hash or a cryptographic hash.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace rt {

/// FNV-1a (Fowler, Noll and Vo), the hash of a text; with the hash of earlier texts, the hash of
/// all of them in a row.
[[nodiscard]] constexpr std::uint64_t fnv1a(std::string_view text,
                                            std::uint64_t hash = 0xcbf29ce484222325u) {
    for (const char each : text) hash = (hash ^ static_cast<unsigned char>(each)) * 0x100000001b3u;
    return hash;
}

/// A hash in which every bit of the result depends on every bit of the value (Appleby's finalizer
/// of MurmurHash3).
[[nodiscard]] constexpr std::uint32_t mixed_bits(std::uint32_t value) {
    value ^= value >> 16;
    value *= 0x85ebca6bU;
    value ^= value >> 13;
    value *= 0xc2b2ae35U;
    return value ^ (value >> 16);
}

/// The two halves of a key of 128 bits.
using HashKey = std::array<std::uint64_t, 2>;

/// SipHash-2-4 of the text, which does not reveal the key (Aumasson, Bernstein: SipHash, a fast
/// short-input PRF, 2012, §2).
[[nodiscard]] constexpr std::uint64_t keyed_hash(HashKey key, std::string_view text) {
    std::uint64_t a = key[0] ^ 0x736f6d6570736575u;
    std::uint64_t b = key[1] ^ 0x646f72616e646f6du;
    std::uint64_t c = key[0] ^ 0x6c7967656e657261u;
    std::uint64_t d = key[1] ^ 0x7465646279746573u;
    const auto round = [&] {
        a += b, b = std::rotl(b, 13) ^ a, a = std::rotl(a, 32);
        c += d, d = std::rotl(d, 16) ^ c;
        a += d, d = std::rotl(d, 21) ^ a;
        c += b, b = std::rotl(b, 17) ^ c, c = std::rotl(c, 32);
    };
    const auto take = [&](std::uint64_t word) {
        d ^= word;
        round();
        round();
        a ^= word;
    };
    std::uint64_t word = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        word |= std::uint64_t(static_cast<unsigned char>(text[i])) << 8 * (i % 8);
        if (i % 8 != 7) continue;
        take(word);
        word = 0;
    }
    take(word | std::uint64_t(text.size()) << 56);
    c ^= 0xff;
    for (int i = 0; i < 4; ++i) round();
    return a ^ b ^ c ^ d;
}

}  // namespace rt
