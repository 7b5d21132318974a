// What a hand-out consists of, as it says itself: steps/handout.txt.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>

namespace rt {

inline constexpr const char* manifest_file = "steps/handout.txt";

/// A title, "Raysteps, …", and what `cksum` prints of each file: its fingerprint and its path.
struct Manifest {
    std::string title;
    /// By path. While an update is under way, a file is right as it was and as it will be.
    std::map<std::string, std::set<std::string>> fingerprints;

    /// Whether the folder has this file, as it was handed out.
    [[nodiscard]] bool matches(const std::filesystem::path& folder, const std::string& path) const;
};

/// Whether the folder is a hand-out, or a student's copy of one.
[[nodiscard]] bool is_handout(const std::filesystem::path& folder);

/// Throws InputError if the folder is no hand-out.
[[nodiscard]] Manifest read_manifest(const std::filesystem::path& folder);

/// Throws InputError if it cannot be written.
void write_manifest(const std::filesystem::path& folder, const Manifest& manifest);

/// Tells two versions of a file apart: "3070535043 1534", as POSIX has it. Throws InputError if it
/// cannot be read.
[[nodiscard]] std::string fingerprint(const std::filesystem::path& file);

}  // namespace rt
