// The manifest of a hand-out: steps/handout.txt.
#pragma once

#include "common/system/files.hpp"

#include <map>
#include <set>
#include <string>

namespace rt {

inline constexpr const char* manifest_file = "steps/handout.txt";

/// A title, "Raysteps, …", and the output of `cksum` for each file: its fingerprint and its path.
struct Manifest {
    std::string title;
    /// By path. During an update, the old and the new fingerprint of a file are both valid.
    std::map<std::string, std::set<std::string>> fingerprints;

    /// True if the folder contains this file unchanged.
    [[nodiscard]] bool matches(const fs::path& folder, const std::string& path) const;
};

/// True if the folder is a hand-out, or a student's copy of one.
[[nodiscard]] bool is_handout(const fs::path& folder);

/// Throws InputError if the folder is not a hand-out.
[[nodiscard]] Manifest read_manifest(const fs::path& folder);

/// Throws InputError if it cannot be written.
void write_manifest(const fs::path& folder, const Manifest& manifest);

/// The file's checksum and size, as printed by POSIX `cksum`: "3070535043 1534". Throws InputError
/// if it cannot be read.
[[nodiscard]] std::string fingerprint(const fs::path& file);

}  // namespace rt
