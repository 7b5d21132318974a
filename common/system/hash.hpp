// FNV-1a (Fowler, Noll and Vo): a hash that is the same on every machine. Two texts with the same
// hash are easy to find; against an attacker, use keyed_hash.hpp or a cryptographic hash.
#pragma once

#include <cstdint>
#include <string_view>

namespace rt {

/// The hash of a text; with the hash of earlier texts, the hash of all of them in a row.
[[nodiscard]] constexpr std::uint64_t fnv1a(std::string_view text,
                                            std::uint64_t hash = 0xcbf29ce484222325u) {
    for (const char each : text) hash = (hash ^ static_cast<unsigned char>(each)) * 0x100000001b3u;
    return hash;
}

}  // namespace rt
