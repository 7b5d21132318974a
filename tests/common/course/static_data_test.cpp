// The variables of a student's file that keep a value from one ray to the next.
#include "common/course/build/static_data.hpp"

#include "tests/kit/catch.hpp"

#include <string>

using namespace rt;

namespace {

/// The names, each with its line: "depth:2 best:5".
std::string found(const std::string& listed, const std::string& source) {
    std::string all;
    for (const StaticVariable& each : static_variables(listed, source))
        all += (all.empty() ? "" : " ") + each.name + ":" + std::to_string(each.line) +
               (each.of_each_thread ? " of each thread" : "");
    return all;
}

std::string symbol(const std::string& name, char type, const std::string& section) {
    return name + "|0000000000000000|   " + type + "  |            OBJECT|0000000000000004|     |" +
           section + "\n";
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
    CHECK(found(symbol(local + "depth", 'b', ".bss"), source) == "depth:2");
    CHECK(found(symbol("rt::trace(double)::best", 'b', ".bss"), source) == "best:5");
    CHECK(found(symbol("_ZZN2rt5traceEdE4best.0", 'b', ".bss"), source) == "best:5");
    CHECK(found(symbol("rt::depth", 'u', ".bss._ZN2rt5depthE"), source) == "depth:2");
    CHECK(found(symbol(local + "text", 'd', ".data.rel.local"), source) == "text:4");
    CHECK(found(symbol(local + "here", 'd', ".tdata"), source) == "here:4 of each thread");
    CHECK(found(symbol(local + "depth", 's', "__DATA,__const"), source).empty());
    CHECK(found(symbol(local + "table", 'b', ".bss"), source).empty());
    CHECK(found(symbol("rt::trace(double)::k", 'b', ".bss"), source).empty());
    CHECK(found(symbol("guard variable for rt::trace(double)::best", 'b', ".bss"), source).empty());
    CHECK(found(symbol(local + "names", 'd', ".data.rel.ro.local"), source).empty());
    CHECK(found(symbol("std::__ioinit", 'b', ".bss"), source).empty());
    CHECK(found(symbol("rt::of_a_header", 'b', ".bss"), source).empty());
    CHECK(found(symbol("rt::trace(double)", 'T', ".text") + symbol(local + "depth", 'b', ".bss") +
                    symbol("rt::trace(double)::best", 'b', ".bss"),
                source) == "depth:2 best:5");
}
