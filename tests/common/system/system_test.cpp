// Threads, texts of unknown content, huge pages, and seeds.
#include "common/system/parallel_for.hpp"

#include "common/system/escaping.hpp"
#include "common/system/hash.hpp"
#include "common/system/huge_pages.hpp"

#include "tests/kit/catch.hpp"
#include "tests/kit/random.hpp"
#include "tests/kit/seed.hpp"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

using namespace rt;

TEST_CASE("in parallel: each piece is done once") {
    for (const int threads : {1, 2, 7}) {
        std::vector<int> times(1000);
        parallel_for(threads, times.size(), nullptr, [&](std::size_t i) { ++times[i]; });
        CHECK(std::ranges::count(times, 1) == 1000);
    }
    parallel_for(3, 0, nullptr, [](std::size_t) { FAIL("no work was expected"); });
}

TEST_CASE("in parallel: no piece is begun once it is to stop") {
    std::atomic<bool> stop = false;
    std::atomic<int> done = 0;
    parallel_for(2, 1'000'000, &stop, [&](std::size_t i) {
        if (i == 10) stop = true;
        ++done;
    });
    CHECK(done >= 11);
    CHECK(done < 1'000'000);
    parallel_for(2, 10, &stop, [](std::size_t) { FAIL("the work was stopped"); });
}

TEST_CASE("in parallel: an exception of a piece is rethrown after the others have ended") {
    for (const int threads : {1, 4}) {
        std::atomic<int> at_work = 0;
        const auto work = [&](std::size_t i) {
            if (i == 5) throw std::runtime_error("the sixth");
            ++at_work;
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
            --at_work;
        };
        CHECK_THROWS_WITH(parallel_for(threads, 100, nullptr, work), "the sixth");
        CHECK(at_work == 0);
    }
}

// Text of unknown content in messages and URLs.

TEST_CASE("a quoted text is short, and printable ASCII") {
    CHECK(rt::quoted("") == "\"\"");
    CHECK(rt::quoted("a b~") == "\"a b~\"");
    CHECK(rt::quoted("\x1B[31m\n\x7F") == "\"\\x1B[31m\\x0A\\x7F\"");
    CHECK(rt::quoted("é") == "\"\\xC3\\xA9\"");
    CHECK(rt::quoted(std::string(40, 'a')) == '"' + std::string(40, 'a') + '"');
    CHECK(rt::quoted(std::string(41, 'a')) == '"' + std::string(40, 'a') + "...\"");
}

TEST_CASE("percent-encoding keeps RFC 3986's unreserved characters alone") {
    CHECK(percent_encoded("a_b-1.png~") == "a_b-1.png~");
    CHECK(percent_encoded("../é\n") == "..%2F%C3%A9%0A");
    CHECK(percent_encoded("100 %") == "100%20%25");
}

TEST_CASE("a word for the shell is in quotes if it needs any") {
    CHECK(shell_word("a-1/b_2.png") == "a-1/b_2.png");
    CHECK(shell_word("my scene.rt") == "'my scene.rt'");
    CHECK(shell_word("it's") == "'it'\\''s'");
    CHECK(shell_word("") == "''");
}

// Vectors in huge pages, and what the system knows of them.

namespace {

/// The flags of the mapping with this address: "hg" if huge pages are requested. Empty on a system
/// other than Linux.
std::string flags_of_mapping(const void* address) {
    std::ifstream mappings("/proc/self/smaps");
    bool is_inside = false;
    for (std::string line; std::getline(mappings, line);) {
        std::uintptr_t begin = 0;
        std::uintptr_t end = 0;
        char dash = 0;
        if (std::istringstream(line) >> std::hex >> begin >> dash >> end && dash == '-') {
            const auto place = reinterpret_cast<std::uintptr_t>(address);
            is_inside = begin <= place && place < end;
        }
        if (is_inside && line.starts_with("VmFlags:")) return line + " ";
    }
    return "";
}

}  // namespace

TEST_CASE("a large vector is in memory for which huge pages are requested (contract)") {
    std::vector<double> items;
    reserve_huge(items, std::size_t(1) << 20);
    REQUIRE(items.capacity() >= std::size_t(1) << 20);
    const std::string flags = flags_of_mapping(items.data() + items.capacity() / 2);
    if (!flags.empty() && std::filesystem::exists("/sys/kernel/mm/transparent_hugepage"))
        CHECK(flags.find(" hg ") != std::string::npos);
    items.resize(items.capacity(), 1);
    CHECK(items.back() == 1);
}

TEST_CASE("a small vector is like any other (contract)") {
    std::vector<double> none;
    reserve_huge(none, 0);
    CHECK(none.empty());
    std::vector<double> few;
    reserve_huge(few, 100);
    few.assign(100, 2);
    CHECK(few.capacity() == 100);
}

// The seeds of random cases: different seeds, names and indices share no input.

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
