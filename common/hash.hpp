// FNV-1a, the hash of Fowler, Noll and Vo: the same on every machine. Anybody can find two texts
// with the same hash: what must resist a person needs keyed_hash.hpp or a cryptographic hash.
#pragma once

#include <cstdint>
#include <string_view>

namespace rt {

/// The hash of a text, or of all texts so far if the hash of the ones before it is given.
[[nodiscard]] constexpr std::uint64_t fnv1a(std::string_view text,
                                            std::uint64_t hash = 0xcbf29ce484222325u) {
    for (const char each : text) hash = (hash ^ static_cast<unsigned char>(each)) * 0x100000001b3u;
    return hash;
}

}  // namespace rt
