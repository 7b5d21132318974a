// unpack FOLDER MEGABYTES < ARCHIVE
//
// Unpacks the possible files of a student from an untrusted archive: archives, and sources with
// nearly the name of a stage's file. It runs in the sandbox. The files in the folder are named "1",
// "2", …, whatever their names in the archive, so that no name leads to another folder. The file
// "list" describes them: a line "KIND NUMBER LENGTH", then the name, LENGTH bytes.
#include "common/course/grade/sandbox/source_names.hpp"

#include <archive.h>
#include <archive_entry.h>

#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace {

namespace fs = std::filesystem;

constexpr std::size_t largest_source = 256 * 1024;
constexpr std::size_t largest_archive = 31 << 20;
constexpr int most_files = 20000;
constexpr std::size_t most_read = 32;  // times the allowed size of the unpacked files
constexpr int most_idle = 100000;      // names of folders, and of files of no use

class Unpacking {
public:
    Unpacking(const fs::path& folder, std::size_t megabytes)
        : folder_(folder), left_(megabytes << 20), list_(folder / "list", std::ios::binary) {}

    void take(archive* from, archive_entry* entry) {
        const char* text = archive_entry_pathname(entry);
        if (text == nullptr) text = archive_entry_pathname_utf8(entry);
        const auto type = archive_entry_filetype(entry);
        if (text == nullptr && type == AE_IFDIR) return;
        if (text == nullptr) return list("nameless", "");  // not UTF-8, though marked as that
        const std::string name = text;
        const fs::path path = name;
        for (const fs::path& part : path)
            if (rt::grade::is_litter(part.string())) return;
        if (type == AE_IFDIR) return list("folder", name);
        std::string file = path.filename().string();
        if (const auto labeled = rt::grade::label(file)) file = labeled->name;
        const bool archived = rt::grade::is_archive(file);
        if (!archived && rt::grade::named_for(file).fit < rt::grade::Fit::near)
            return list("other", name);
        if (type != AE_IFREG || archive_entry_hardlink(entry) != nullptr) return list("link", name);
        if (archive_entry_is_encrypted(entry) != 0) return list("locked", name);
        write(from, name, archived ? largest_archive : largest_source, archived);
    }

    /// The last line of a list that is whole.
    [[nodiscard]] bool end(const std::string& kind) {
        list(kind, "");
        list_.close();
        return bool(list_);
    }

private:
    void list(const std::string& kind, const std::string& name, int number = 0) {
        const bool idle = kind == "folder" || kind == "other";
        if (idle && ++named_ > most_idle) return;
        list_ << kind << ' ' << number << ' ' << name.size() << '\n' << name << '\n';
    }

    void write(archive* from, const std::string& name, std::size_t largest, bool archived) {
        if (files_ == most_files) return list("large", name);
        const fs::path file = folder_ / std::to_string(++files_);
        std::ofstream out(file, std::ios::binary);
        char block[16384];
        std::size_t size = 0;
        while (true) {
            const la_ssize_t count = archive_read_data(from, block, sizeof block);
            if (count == 0) break;
            if (count < 0) return drop(file, "damaged", name);
            size += std::size_t(count);
            if (size > largest || std::size_t(count) > left_) return drop(file, "large", name);
            left_ -= std::size_t(count);
            out.write(block, count);
        }
        out.close();
        if (!out) return drop(file, "large", name);
        list(archived ? "archive" : "source", name, files_);
    }

    void drop(const fs::path& file, const std::string& kind, const std::string& name) {
        std::error_code none;
        fs::remove(file, none);
        list(kind, name);
    }

    fs::path folder_;
    std::size_t left_;
    std::ofstream list_;
    int files_ = 0;
    int named_ = 0;
};

/// Only the formats that are read in memory: some others in libarchive start programs, or open
/// files.
archive* opened_input() {
    archive* from = archive_read_new();
    for (const auto support :
         {archive_read_support_filter_gzip, archive_read_support_filter_bzip2,
          archive_read_support_filter_xz, archive_read_support_filter_lzma,
          archive_read_support_filter_zstd, archive_read_support_filter_compress,
          archive_read_support_format_zip, archive_read_support_format_tar,
          archive_read_support_format_7zip, archive_read_support_format_rar,
          archive_read_support_format_rar5})
        support(from);
    constexpr std::size_t block = 65536;
    return archive_read_open_filename(from, nullptr, block) == ARCHIVE_OK ? from : nullptr;
}

}  // namespace

int main(int count, char** words) {
    if (count != 3) return 2;
    std::setlocale(LC_ALL, "C.UTF-8");  // names of other encodings are kept as bytes
    const std::size_t megabytes = std::strtoul(words[2], nullptr, 10);
    Unpacking unpacking(words[1], megabytes);
    archive* from = opened_input();
    if (from == nullptr) return 1;
    archive_entry* entry = nullptr;
    int status = 0;
    while ((status = archive_read_next_header(from, &entry)) >= ARCHIVE_WARN &&
           status != ARCHIVE_EOF) {
        const auto read = archive_filter_bytes(from, 0);
        if (read > la_int64_t(most_read * (megabytes << 20))) break;
        unpacking.take(from, entry);
    }
    return unpacking.end(status == ARCHIVE_EOF ? "end" : "broken") ? 0 : 1;
}
