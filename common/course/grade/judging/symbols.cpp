#include "common/course/grade/judging/symbols.hpp"

#include <cxxabi.h>

#include <cctype>
#include <cstdlib>
#include <memory>

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

/// True if the name of a function or of one of its types is in the project's namespace.
bool is_of_project(const std::string& name) {
    for (std::size_t at = name.find("rt::"); at != std::string::npos;
         at = name.find("rt::", at + 1))
        if (at == 0 || (std::isalnum(static_cast<unsigned char>(name[at - 1])) == 0 &&
                        name[at - 1] != '_' && name[at - 1] != ':'))
            return true;
    return false;
}

std::string complaint_of_use(const std::string& symbol, const StageFunctions& functions) {
    if (functions.own.count(symbol) == 1 || functions.callable.count(symbol) == 1) return "";
    const std::string name = demangled(symbol);
    if (!is_of_project(name)) return "";
    return "Your file calls " + name +
           ", which it does not define itself, and which this stage may not call: the stage's page "
           "lists the allowed functions.";
}

std::string complaint_of_definition(const ObjectSymbol& symbol, const StageFunctions& functions) {
    const std::string& name = symbol.name;
    if (symbol.is_indirect)
        return "Your file defines " + demangled(name) + " as an indirect function.";
    if (!symbol.is_code) return "";  // a variable: it belongs to the student, whatever its name
    if (name == "main") return "Your file defines main: the program that calls you has its own.";
    if (starts_with_one_of(name, {"_Znw", "_Zna", "_Zdl", "_Zda"}))
        return "Your file replaces " + demangled(name) + ", which all programs share.";
    if (!name.starts_with("_Z"))
        return "Your file defines " + name +
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
            return "Your file has a version of a symbol: " + symbol.name + ".";
        std::string sentence = symbol.is_defined ? complaint_of_definition(symbol, functions)
                                                 : complaint_of_use(symbol.name, functions);
        if (!sentence.empty()) return sentence;
    }
    return missing_functions(object, functions);
}

}  // namespace rt::grade
