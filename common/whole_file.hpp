// A file that is written whole or not at all.
#pragma once

#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>

namespace rt {

/// A new file beside the one that is meant, whose place it takes once it is whole. Its name is one
/// that no other file has, so that several programs at once each write a whole file; it is gone
/// with its scope, whatever happens.
class WholeFile {
public:
    /// Makes the folder if there is none. A symbolic link stays: what it leads to is meant. Throws
    /// InputError.
    explicit WholeFile(const std::filesystem::path& file);
    ~WholeFile();
    WholeFile(const WholeFile&) = delete;
    WholeFile& operator=(const WholeFile&) = delete;

    [[nodiscard]] std::FILE* stream() const { return stream_; }

    /// Throws InputError.
    void write(std::string_view text);

    /// Renames it, once: an older file is replaced, and its permissions kept. Throws InputError.
    void take_its_place();

private:
    std::filesystem::path file_;    ///< as it was named
    std::filesystem::path target_;  ///< where that leads to
    std::filesystem::path part_;
    std::FILE* stream_ = nullptr;
};

/// The file that the name leads to, through symbolic links; it need not be there. Throws InputError
/// if the links have no end.
[[nodiscard]] std::filesystem::path behind_links(const std::filesystem::path& file);

/// Throws InputError if no WholeFile could be made there. Leaves nothing.
void check_folder_of(const std::filesystem::path& file);

/// Whether a file of that name is a WholeFile, one that was left over if no program writes now.
[[nodiscard]] bool is_part_file(const std::filesystem::path& file);

}  // namespace rt
