// Files that are written whole or not at all, and their paths.
#pragma once

#include "common/system/text.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace rt {

namespace fs = std::filesystem;

/// The file's text. Throws InputError if it cannot be read.
[[nodiscard]] std::string read_text(const fs::path& file);

/// The lines of the file; none if there is no such file. Throws InputError if it cannot be read.
[[nodiscard]] std::vector<std::string> lines_in(const fs::path& file);

/// Writes a WholeFile: after an interruption, or on a full disk, the old contents are still there.
/// Throws InputError on failure.
void write_text(const fs::path& file, const std::string& text);

/// The same with another file's text and permissions.
void copy_whole(const fs::path& from, const fs::path& to);

/// The files of a folder with this extension, sorted by name; empty if there is no such folder.
[[nodiscard]] std::vector<fs::path> files_in(const fs::path& folder, const std::string& ending);

/// The system's folder for temporary files. Throws InputError if TMPDIR names no folder.
[[nodiscard]] fs::path temporary_place();

/// Creates a folder whose name is `start` and random letters, and returns its path. Only its owner
/// may enter it. Throws InputError.
[[nodiscard]] fs::path make_folder(const fs::path& parent, const std::string& start);

/// True if the path is free for a new folder: there is nothing, or an empty folder and no link.
[[nodiscard]] bool is_free_for_folder(const fs::path& path);

/// Throws InputError, with the name that the user typed, if the path is not free for a new folder.
void refuse_what_is_there(const fs::path& typed, const fs::path& path);

/// A new folder with a unique name, removed at the end of its scope.
class TemporaryFolder {
public:
    /// Its name begins with `start`. Throws InputError.
    explicit TemporaryFolder(const fs::path& parent = temporary_place(),
                             const std::string& start = "raysteps.");
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    [[nodiscard]] const fs::path& path() const { return path_; }

private:
    fs::path path_;
};

}  // namespace rt
