// The seeds of random cases: different seeds, names and indices share no input.
#include "common/system/keyed_hash.hpp"

#include "tests/kit/random.hpp"
#include "tests/kit/seed.hpp"

#include "tests/kit/catch.hpp"

#include <set>
#include <string>

using namespace rt;

TEST_CASE("a keyed hash is SipHash-2-4") {
    // The key and the texts of the paper's appendix A, and of its authors' vectors.h.
    const HashKey key{0x0706050403020100, 0x0f0e0d0c0b0a0908};
    std::string text;
    for (char i = 0; i < 15; ++i) text += i;
    CHECK(keyed_hash(key, text) == 0xa129ca6149be45e5);
    CHECK(keyed_hash(key, "") == 0x726fdb47dd0e0e31);
    CHECK(keyed_hash(key, text.substr(0, 8)) == 0x93f5f5799a932462);
}

TEST_CASE("seeds, cases and places that are neighbors share no question") {
    std::set<double> first;
    std::size_t count = 0;
    for (std::uint64_t seed : {0u, 1u, 2u, 3u, 42u})
        for (const char* name : {"a", "b", "ab", "edges belong to the triangle (MRT §5)"})
            for (std::uint64_t i = 0; i < 300; ++i, ++count)
                first.insert(Random(draw_number(seed, name, i)).choice());
    CHECK(first.size() == count);
}
