// Vectors in huge pages, and what the system knows of them.
#include "common/system/huge_pages.hpp"

#include "tests/kit/catch.hpp"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

using namespace rt;

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
