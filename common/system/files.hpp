// Files that are written whole or not at all.
#pragma once

#include "common/system/text.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace rt {

/// The file's text. Throws InputError if it cannot be read.
[[nodiscard]] std::string read_text(const std::filesystem::path& file);

/// Writes a WholeFile: after an interruption, or on a full disk, the old contents are still there.
/// Throws InputError on failure.
void write_text(const std::filesystem::path& file, const std::string& text);

/// The same with another file's text and permissions.
void copy_whole(const std::filesystem::path& from, const std::filesystem::path& to);

/// The files of a folder with this extension, sorted by name; empty if there is no such folder.
[[nodiscard]] std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder,
                                                          const std::string& ending);

/// The system's folder for temporary files. Throws InputError if TMPDIR names no folder.
[[nodiscard]] std::filesystem::path temporary_place();

/// Creates a folder whose name is `start` and random letters, and returns its path. Only its owner
/// may enter it. Throws InputError.
[[nodiscard]] std::filesystem::path make_folder(const std::filesystem::path& parent,
                                                const std::string& start);

/// True if the path is free for a new folder: there is nothing, or an empty folder and no link.
[[nodiscard]] bool is_free_for_folder(const std::filesystem::path& path);

/// Throws InputError, with the name that the user typed, if the path is not free for a new folder.
void refuse_what_is_there(const std::filesystem::path& typed, const std::filesystem::path& path);

/// A new folder with a unique name, removed at the end of its scope.
class TemporaryFolder {
public:
    /// Throws InputError.
    explicit TemporaryFolder(const std::filesystem::path& parent = temporary_place());
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

}  // namespace rt
