#include "common/course/grade/symbols.hpp"

#include <cxxabi.h>

#include <array>
#include <cstdlib>
#include <memory>
#include <sstream>

namespace rt::grade {

namespace {

std::string demangled(const std::string& symbol) {
    int status = 0;
    const std::unique_ptr<char, void (*)(void*)> name(
        abi::__cxa_demangle(symbol.c_str(), nullptr, nullptr, &status), std::free);
    return status == 0 ? name.get() : symbol;
}

bool starts_with_one_of(std::string_view symbol, std::initializer_list<std::string_view> starts) {
    for (const std::string_view start : starts)
        if (symbol.starts_with(start)) return true;
    return false;
}

/// nm's letters of what the compiler makes of headers, in any file that needs it.
bool is_shared(char type) {
    return std::string_view("WVuwv").find(type) != std::string_view::npos;
}

/// A global variable: nobody's but his, whatever its name.
bool is_variable(char type) {
    return std::string_view("BDRCGSV").find(type) != std::string_view::npos;
}

std::string complaint(const std::string& symbol, char type) {
    if (type == 'U' || is_variable(type)) return "";
    if (symbol == "main") return "Your file defines main: the program that calls you has its own.";
    if (type == 'i') return "Your file defines " + demangled(symbol) + " as an indirect function.";
    if (starts_with_one_of(symbol, {"_Znw", "_Zna", "_Zdl", "_Zda"}))
        return "Your file replaces " + demangled(symbol) + ", which is everybody's.";
    if (!symbol.starts_with("_Z"))
        return "Your file defines " + symbol +
               " as a C function, which may replace the library's: put it into the anonymous "
               "namespace.";
    const bool is_of_others =
        starts_with_one_of(symbol, {"_ZSt", "_ZNSt", "_ZNKSt", "_ZN5Catch", "_ZNK5Catch",
                                    "_ZN10__cxxabiv1", "_ZN2rt8contract"});
    if (is_of_others && !is_shared(type))
        return "Your file defines " + demangled(symbol) + ", which is not the stage's.";
    return "";
}

}  // namespace

std::string foreign_symbol(std::string_view listed) {
    std::istringstream lines{std::string(listed)};
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string symbol;
        char type = 'U';
        if (!(words >> symbol >> type)) continue;
        const std::string sentence = complaint(symbol, type);
        if (!sentence.empty()) return sentence;
    }
    return "";
}

}  // namespace rt::grade
