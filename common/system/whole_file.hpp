// A file that is written completely or not at all.
#pragma once

#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace rt {

/// A temporary file in the same folder as the target, renamed to it when it is complete. Its name
/// is unique, so that several programs at once each write a complete file. The destructor removes
/// it, whatever happens, and the folders that were made for it, unless it has its place.
class WholeFile {
public:
    /// Creates the folder if there is none. A symbolic link stays, and its target is written.
    /// Throws InputError.
    explicit WholeFile(const std::filesystem::path& file);
    ~WholeFile();
    WholeFile(const WholeFile&) = delete;
    WholeFile& operator=(const WholeFile&) = delete;

    /// Throws InputError.
    void write(std::string_view text);

    /// Renames the temporary file to its target; call it once. An older file is replaced, and its
    /// permissions are kept. Throws InputError.
    void take_its_place();

private:
    std::filesystem::path file_;    ///< path as given
    std::filesystem::path target_;  ///< path with symbolic links resolved
    std::filesystem::path part_;
    std::vector<std::filesystem::path> made_;  ///< folders, the innermost first
    std::FILE* stream_ = nullptr;
};

/// Resolves symbolic links; the file need not exist. Throws InputError if the links form a cycle.
[[nodiscard]] std::filesystem::path behind_links(const std::filesystem::path& file);

/// Throws InputError if no WholeFile could be created for this file. Creates no file.
void check_folder_of(const std::filesystem::path& file);

/// Returns whether the name is that of the temporary file of a WholeFile. If no program is writing,
/// it is a leftover.
[[nodiscard]] bool is_part_file(const std::filesystem::path& file);

}  // namespace rt
