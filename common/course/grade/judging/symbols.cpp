#include "common/course/grade/judging/symbols.hpp"

#include "common/system/text.hpp"

#include <cxxabi.h>
#include <elf.h>
#include <link.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <stdexcept>

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
    return "Your file does not define " + joined(missing, demangled) + ".";
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

namespace {

using Header = ElfW(Ehdr);
using Section = ElfW(Shdr);
using Symbol = ElfW(Sym);

constexpr unsigned char own_class = sizeof(void*) == 8 ? ELFCLASS64 : ELFCLASS32;

// Names may share their ends in the file: all together may be far longer than the file is.
constexpr std::size_t most_bytes_of_names = std::size_t(16) << 20;

class CutShort : public std::exception {};

/// Reads bytes with bounds checks. Throws CutShort past the end.
class Bytes {
public:
    explicit Bytes(std::string_view bytes) : bytes_(bytes) {}

    [[nodiscard]] std::string_view part(std::size_t from, std::size_t size) const {
        if (from > bytes_.size() || size > bytes_.size() - from) throw CutShort();
        return bytes_.substr(from, size);
    }
    template <class T>
    [[nodiscard]] T at(std::size_t from) const {
        T value;
        std::memcpy(&value, part(from, sizeof(T)).data(), sizeof(T));
        return value;
    }
    [[nodiscard]] std::string_view rest(std::size_t from) const {
        return part(from, bytes_.size() - std::min(from, bytes_.size()));
    }
    /// The string that starts there, without the zero at its end.
    [[nodiscard]] std::string_view text(std::size_t from) const {
        const std::string_view all = rest(from);
        const std::size_t end = all.find('\0');
        if (end == std::string_view::npos) throw CutShort();
        return all.substr(0, end);
    }

private:
    std::string_view bytes_;
};

class Reader {
public:
    explicit Reader(std::string_view bytes) : bytes_(bytes), header_(bytes_.at<Header>(0)) {
        const bool is_object = std::memcmp(header_.e_ident, ELFMAG, SELFMAG) == 0 &&
                               header_.e_ident[EI_CLASS] == own_class && header_.e_type == ET_REL &&
                               header_.e_shentsize == sizeof(Section);
        // With 65280 sections and more, their number is elsewhere: no person writes these.
        if (!is_object || header_.e_shnum == 0) throw CutShort();
        for (std::size_t i = 0; i < header_.e_shnum; ++i)
            sections_.push_back(bytes_.at<Section>(header_.e_shoff + i * sizeof(Section)));
        for (const Section& each : sections_) has_code_.push_back(has_code(each));
    }

    [[nodiscard]] ObjectFile read() const {
        ObjectFile object;
        for (const Section& section : sections_) {
            if (is_named(section, ".gnu.lto_")) object.is_intermediate = true;
            if (section.sh_type == SHT_SYMTAB) read_symbols(section, object);
        }
        return object;
    }

private:
    [[nodiscard]] const Section& section(std::size_t i) const {
        if (i >= sections_.size()) throw CutShort();
        return sections_[i];
    }
    [[nodiscard]] Bytes content(const Section& section) const {
        if (section.sh_type == SHT_NOBITS) return Bytes({});
        return Bytes(bytes_.part(section.sh_offset, section.sh_size));
    }
    [[nodiscard]] bool is_named(const Section& of, std::string_view start) const {
        return content(section(header_.e_shstrndx)).rest(of.sh_name).starts_with(start);
    }

    void read_symbols(const Section& table, ObjectFile& object) const {
        const Bytes symbols = content(table);
        const Bytes names = content(section(table.sh_link));
        std::size_t bytes_of_names = 0;
        for (std::size_t at = 0; at + sizeof(Symbol) <= table.sh_size; at += sizeof(Symbol)) {
            const Symbol symbol = symbols.at<Symbol>(at);
            const auto binding = ELF32_ST_BIND(symbol.st_info);  // the same of 64 bits
            if (binding == STB_LOCAL) continue;
            const std::string_view name = names.text(symbol.st_name);
            bytes_of_names += name.size();
            if (bytes_of_names > most_bytes_of_names) throw CutShort();
            if (name.starts_with("__gnu_lto_")) object.is_intermediate = true;
            object.symbols.push_back({.name = std::string(name),
                                      .is_defined = symbol.st_shndx != SHN_UNDEF,
                                      .is_code = is_code(symbol.st_shndx),
                                      .is_indirect = ELF32_ST_TYPE(symbol.st_info) == STT_GNU_IFUNC,
                                      .is_weak = binding != STB_GLOBAL});
        }
    }

    /// A linker puts .text.anything into the code, even if that section has other flags.
    [[nodiscard]] bool has_code(const Section& place) const {
        return (place.sh_flags & SHF_EXECINSTR) != 0 || is_named(place, ".text") ||
               is_named(place, ".init") || is_named(place, ".fini");
    }

    /// Decided by the section, not by the symbol's own type.
    [[nodiscard]] bool is_code(std::size_t index) const {
        if (index == SHN_UNDEF || index == SHN_COMMON) return false;
        if (index >= SHN_LORESERVE) return true;
        if (index >= has_code_.size()) throw CutShort();
        return has_code_[index];
    }

    Bytes bytes_;
    Header header_;
    std::vector<Section> sections_;
    std::vector<bool> has_code_;  ///< of each section
};

}  // namespace

std::optional<ObjectFile> parse_object(std::string_view bytes) {
    try {
        return Reader(bytes).read();
    } catch (const CutShort&) {
        return std::nullopt;
    }
}

}  // namespace rt::grade
