// An object file, parsed from untrusted bytes, and the symbols that it defines or calls without
// permission.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace rt::grade {

/// A symbol that is visible to other objects.
struct ObjectSymbol {
    std::string name;
    bool is_defined = false;
    bool is_code = false;      ///< in an executable section, or at an absolute address
    bool is_indirect = false;  ///< called by the loader to select the function (ifunc)
    bool is_weak = false;      ///< emitted for header code by every file that uses it
};

struct ObjectFile {
    std::vector<ObjectSymbol> symbols;
    bool is_intermediate = false;  ///< from a compiler that defers the compile to the linker (LTO)
};

/// Returns nothing if the bytes are not an object file of this machine (ELF), or are truncated.
[[nodiscard]] std::optional<ObjectFile> parse_object(std::string_view bytes);

/// The functions of all contracts, and of common/, by their linker names: seats/graded/*.txt.
struct StageFunctions {
    std::set<std::string> own;       ///< the stage's functions, which the student writes
    std::set<std::string> callable;  ///< other functions that the student may call
    std::set<std::string> others;    ///< those of the other stages
};

/// A sentence on the first such symbol; empty if there is none. It is an explanation, not a
/// defense: functions that are not callable are missing when the worker is linked, and the sandbox
/// stops the rest.
[[nodiscard]] std::string foreign_symbol(const ObjectFile& object, const StageFunctions& functions);

}  // namespace rt::grade
