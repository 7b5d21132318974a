// Archives of strangers.
#pragma once

#include "common/course/grade/compile.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace rt::grade {

/// A name in an archive.
struct Entry {
    enum class Kind { folder, other, source, archive, link, locked, large, damaged };
    Kind kind = Kind::other;
    std::string name;
    std::filesystem::path file;  ///< what was taken out: a source, an archive
};

struct Unpacked {
    std::vector<Entry> entries;
    bool whole = false;  ///< else the archive is damaged, or a bomb: these were before that
};

/// Takes the sources that are named nearly like a stage's, and the archives, out of an archive into
/// a folder of the workshop, by a sealed tool; all of them have so many megabytes at most. Nothing
/// if the archive cannot be read at all. Throws ProgramError or filesystem_error if it is we who
/// fail.
[[nodiscard]] std::optional<Unpacked> unpack(const Workshop& workshop,
                                             const std::filesystem::path& archive,
                                             const std::filesystem::path& folder, int megabytes);

/// The text, if the file is one: no link, no device, no pipe, of a size that a person writes.
[[nodiscard]] std::optional<std::string> source_text(const std::filesystem::path& file);

}  // namespace rt::grade
