// The variables of a student's file that keep a value from one ray to the next.
#include "common/course/build/static_data.hpp"

#include "tests/kit/catch.hpp"

#include <string>

using namespace rt;

namespace {

/// The names, each with its line: "depth:2 best:5".
std::string found(const std::vector<Symbol>& symbols, const std::string& source) {
    std::string all;
    for (const StaticVariable& each : static_variables(symbols, source))
        all += (all.empty() ? "" : " ") + each.name + ":" + std::to_string(each.line) +
               (each.of_each_thread ? " of each thread" : "");
    return all;
}

}  // namespace

TEST_CASE("variables that outlive a call are named with their lines, constants are not") {
    const std::string source =
        "// int depth is a count\n"
        "int depth = 0;\n"
        "const std::vector<double> table = {1, 2};\n"
        "thread_local int here = 3; const char* text = \"here text\";\n"
        "double trace() { static std::optional<int> best; static const double k = cos(1); }\n"
        "const std::array<const char*, 2> names = {\"a\", \"b\"};\n";
    const std::string local = "rt::(anonymous namespace)::";
    CHECK(found({{local + "depth", 'b', ".bss"}}, source) == "depth:2");
    CHECK(found({{"rt::trace(double)::best", 'b', ".bss"}}, source) == "best:5");
    CHECK(found({{"_ZZN2rt5traceEdE4best.0", 'b', ".bss"}}, source) == "best:5");
    CHECK(found({{"rt::depth", 'u', ".bss._ZN2rt5depthE"}}, source) == "depth:2");
    CHECK(found({{local + "text", 'd', ".data.rel.local"}}, source) == "text:4");
    CHECK(found({{local + "here", 'd', ".tdata"}}, source) == "here:4 of each thread");
    CHECK(found({{local + "depth", 's', "__DATA,__const"}}, source).empty());
    CHECK(found({{local + "table", 'b', ".bss"}}, source).empty());
    CHECK(found({{"rt::trace(double)::k", 'b', ".bss"}}, source).empty());
    CHECK(found({{"guard variable for rt::trace(double)::best", 'b', ".bss"}}, source).empty());
    CHECK(found({{local + "names", 'd', ".data.rel.ro.local"}}, source).empty());
    CHECK(found({{"std::__ioinit", 'b', ".bss"}}, source).empty());
    CHECK(found({{"rt::of_a_header", 'b', ".bss"}}, source).empty());
    CHECK(found({{"rt::trace(double)", 'T', ".text"},
                 {local + "depth", 'b', ".bss"},
                 {"rt::trace(double)::best", 'b', ".bss"}},
                source) == "depth:2 best:5");
}

TEST_CASE("a symbol is read from a line of nm, by binutils or by LLVM") {
    const auto best = read_symbol(
        "rt::trace(double)::best|0000000000000010|   b  |            OBJECT|0000000000000018|     "
        "|.bss");
    REQUIRE(best);
    CHECK(best->name == "rt::trace(double)::best");
    CHECK(best->kind == 'b');
    CHECK(best->section == ".bss");
    const auto either = read_symbol(
        " rt::operator|(rt::A, rt::A)  |0000000000000000|   T  |FUNC|0000000000000005|     |.text");
    REQUIRE(either);
    CHECK(either->name == "rt::operator|(rt::A, rt::A)");
    CHECK(either->kind == 'T');
    for (const char* line : {"", "|", "||||||", "Symbols from sphere.cpp.o:",
                             "Name   Value   Class   Type   Size   Line  Section"})
        CHECK(!read_symbol(line));
}
