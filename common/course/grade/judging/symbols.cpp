#include "common/course/grade/judging/symbols.hpp"

#include <cxxabi.h>

#include <cctype>
#include <cstdlib>
#include <memory>

namespace rt::grade {

namespace {

// Each part of a mangled name may stand for the whole before it, twice and more: 400 characters may
// expand to gigabytes, these to a few megabytes.
constexpr std::size_t longest_demangled = 160;
constexpr std::size_t longest_shown = 400;

/// The name as a student reads it: without an end that is too long for a sentence.
std::string shown(const std::string& name) {
    return name.size() <= longest_shown ? name : name.substr(0, longest_shown) + "…";
}

std::string demangled(const std::string& symbol) {
    if (symbol.size() > longest_demangled) return shown(symbol);
    int status = 0;
    const std::unique_ptr<char, void (*)(void*)> name(
        abi::__cxa_demangle(symbol.c_str(), nullptr, nullptr, &status), std::free);
    return shown(status == 0 ? name.get() : symbol);
}

bool starts_with_one_of(std::string_view symbol, std::initializer_list<std::string_view> starts) {
    for (const std::string_view start : starts)
        if (symbol.starts_with(start)) return true;
    return false;
}

/// True if the mangled name of a function or of one of its types is in the project's namespace.
bool is_of_project(const std::string& symbol) {
    const std::string rt = "2rt";  // the length of the name, and the name
    for (std::size_t at = symbol.find(rt); at != std::string::npos; at = symbol.find(rt, at + 1))
        if (at > 0 && std::isdigit(static_cast<unsigned char>(symbol[at - 1])) == 0)
            return symbol.starts_with("_Z");
    return false;
}

std::string complaint_of_use(const std::string& symbol, const StageFunctions& functions) {
    if (functions.own.count(symbol) == 1 || functions.callable.count(symbol) == 1) return "";
    if (!is_of_project(symbol)) return "";
    return "Your file calls " + demangled(symbol) +
           ", which it does not define itself, and which this stage may not call: the stage's page "
           "lists the allowed functions.";
}

std::string complaint_of_definition(const ObjectSymbol& symbol, const StageFunctions& functions) {
    const std::string& name = symbol.name;
    if (symbol.is_indirect)
        return "Your file defines " + demangled(name) + " as an indirect function.";
    if (!symbol.is_code) return "";  // a variable: it belongs to the student, whatever its name
    if (name == "main") return "Your file defines main: the program that calls you has its own.";
    // Defined by <new> in each file that does not inline them, and by no library.
    for (const char* placement : {"_ZnwmPv", "_ZnamPv", "_ZdlPvS_", "_ZdaPvS_"})
        if (symbol.is_weak && name == placement) return "";
    if (starts_with_one_of(name, {"_Znw", "_Zna", "_Zdl", "_Zda"}))
        return "Your file replaces " + demangled(name) + ", which all programs share.";
    if (!name.starts_with("_Z"))
        return "Your file defines " + shown(name) +
               " as a C function, which may replace the library's: put it into the anonymous "
               "namespace.";
    const bool is_of_library =
        starts_with_one_of(name, {"_ZSt", "_ZNSt", "_ZNKSt", "_ZN5Catch", "_ZNK5Catch",
                                  "_ZN10__cxxabiv1", "_ZN2rt8contract"});
    if ((is_of_library && !symbol.is_weak) || functions.callable.count(name) == 1 ||
        functions.others.count(name) == 1)
        return "Your file defines " + demangled(name) + ", which is not the stage's.";
    return "";
}

std::string missing_functions(const ObjectFile& object, const StageFunctions& functions) {
    std::set<std::string> missing = functions.own;
    for (const ObjectSymbol& symbol : object.symbols)
        if (symbol.is_defined) missing.erase(symbol.name);
    if (missing.empty()) return "";
    std::string names;
    for (const std::string& each : missing) names += (names.empty() ? "" : ", ") + demangled(each);
    return "Your file does not define " + names + ".";
}

}  // namespace

std::string foreign_symbol(const ObjectFile& object, const StageFunctions& functions) {
    if (object.is_intermediate)
        return "Your file makes the compiler leave its work to the linker (LTO), which is not done "
               "here.";
    for (const ObjectSymbol& symbol : object.symbols) {
        if (symbol.name.find('@') != std::string::npos)
            return "Your file has a version of a symbol: " + shown(symbol.name) + ".";
        std::string sentence = symbol.is_defined ? complaint_of_definition(symbol, functions)
                                                 : complaint_of_use(symbol.name, functions);
        if (!sentence.empty()) return sentence;
    }
    return missing_functions(object, functions);
}

}  // namespace rt::grade
