// Hashes that are the same on every machine. Two values with the same hash are easy to find;
// against an attacker, use keyed_hash.hpp or a cryptographic hash.
#pragma once

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

}  // namespace rt
