#include "common/course/grade/judging/object_file.hpp"

#include <elf.h>
#include <link.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace rt::grade {

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
