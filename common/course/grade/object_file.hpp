// What stands in an object file, read from its bytes, which a stranger may have chosen.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rt::grade {

/// A symbol that other objects see.
struct ObjectSymbol {
    std::string name;
    bool is_defined = false;
    bool is_code = false;      ///< in a section that is executed, or at an address of its own
    bool is_indirect = false;  ///< the loader calls it, to be told which function it is
    bool is_weak = false;      ///< as the compiler makes of headers, in any file that needs it
};

struct ObjectFile {
    std::vector<ObjectSymbol> symbols;
    bool is_intermediate = false;  ///< of a compiler that leaves the compile to the linker (LTO)
};

/// Nothing if the bytes are no object file of this machine (ELF), or are cut short.
[[nodiscard]] std::optional<ObjectFile> parse_object(std::string_view bytes);

}  // namespace rt::grade
