// Unpacking of untrusted archives.
#pragma once

#include "common/course/grade/judging/workshop.hpp"
#include "common/system/files.hpp"

#include <optional>
#include <string>
#include <vector>

namespace rt::grade {

struct Entry {
    enum class Kind { folder, other, source, archive, link, locked, large, damaged, nameless };
    Kind kind = Kind::other;
    std::string name;
    fs::path file;  ///< an unpacked file: a source or an archive
};

struct Unpacked {
    std::vector<Entry> entries;
    bool whole = false;  ///< false if the archive is damaged or a bomb: the entries precede the
                         ///< damage
};

/// Unpacks an archive in the sandbox, into a folder of the workshop: only the archives, and the
/// sources with nearly the name of a stage's file. `megabytes` bounds their total size. The
/// archive, which may be far larger, is not copied.
/// Returns nothing if the archive cannot be read at all. Throws ProgramError or filesystem_error if
/// the grader itself fails.
[[nodiscard]] std::optional<Unpacked> unpack(const BuildDirectory& workshop,
                                             const fs::path& archive, const fs::path& folder,
                                             int megabytes);

/// The text, if this is a regular file (no link, device or pipe) of the size of a handwritten
/// source.
[[nodiscard]] std::optional<std::string> source_text(const fs::path& file);

}  // namespace rt::grade
