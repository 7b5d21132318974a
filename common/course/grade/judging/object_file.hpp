// The contents of an object file, parsed from untrusted bytes.
#pragma once

#include <optional>
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

}  // namespace rt::grade
