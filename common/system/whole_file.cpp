#include "common/system/whole_file.hpp"

#include "common/system/input_error.hpp"

#include <cerrno>
#include <cstring>
#include <random>
#include <system_error>
#include <utility>

namespace rt {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view part_start = ".raysteps-";
constexpr std::string_view part_end = ".part";
constexpr std::size_t part_digits = 16;
constexpr std::string_view hex_digits = "0123456789abcdef";

/// The name does not depend on the target's name, which may already have the maximum length.
std::string part_name() {
    std::random_device random;
    std::string name(part_start);
    for (std::size_t i = 0; i < part_digits; ++i) name += hex_digits[random() % 16];
    return name.append(part_end);
}

[[noreturn]] void fail_to_write(const fs::path& file, const std::string& why) {
    throw InputError({file.string()}, "cannot be written: " + why);
}

/// Creates a new file in the folder, and stores its name in `part`.
std::FILE* open_part(const fs::path& folder, const fs::path& meant, fs::path& part) {
    constexpr int tries = 100;
    for (int i = 0; i < tries; ++i) {
        part = folder / part_name();
        // "x": fails if the name exists, also as a symbolic link.
        if (std::FILE* stream = std::fopen(part.string().c_str(), "wbx")) return stream;
        if (errno != EEXIST) break;
    }
    fail_to_write(meant, std::strerror(errno));
}

void remove_part(const fs::path& part) {
    std::error_code not_there;
    fs::remove(part, not_there);
}

/// The folders of this path that do not exist, the innermost first. A link that leads nowhere does.
std::vector<fs::path> missing_folders(fs::path folder) {
    std::vector<fs::path> missing;
    const auto is_missing = [](const fs::path& path) {
        std::error_code none;
        return fs::symlink_status(path, none).type() == fs::file_type::not_found;
    };
    for (; !folder.empty() && is_missing(folder); folder = folder.parent_path())
        missing.push_back(folder);
    return missing;
}

void remove_folders(const std::vector<fs::path>& folders) {
    std::error_code not_empty;
    for (const fs::path& each : folders) fs::remove(each, not_empty);
}

}  // namespace

fs::path behind_links(const fs::path& file) {
    constexpr int most_links = 40;
    fs::path target = file;
    for (int i = 0; i < most_links; ++i) {
        std::error_code none;
        if (!fs::is_symlink(fs::symlink_status(target, none))) return target;
        target = target.parent_path() / fs::read_symlink(target, none);
    }
    throw InputError({file.string()}, "is a symbolic link that leads nowhere");
}

WholeFile::WholeFile(const fs::path& file) : file_(file), target_(behind_links(file)) {
    const fs::path folder = target_.parent_path();
    made_ = missing_folders(folder);
    std::error_code error;
    if (!folder.empty()) fs::create_directories(folder, error);
    try {
        if (error) throw InputError({folder.string()}, "cannot be made: " + error.message());
        stream_ = open_part(folder, file_, part_);
    } catch (const InputError&) {
        remove_folders(made_);
        throw;
    }
}

WholeFile::~WholeFile() {
    if (stream_ != nullptr) std::fclose(stream_);
    if (part_.empty()) return;
    remove_part(part_);
    remove_folders(made_);
}

void WholeFile::write(std::string_view text) {
    if (std::fwrite(text.data(), 1, text.size(), stream_) != text.size())
        fail_to_write(file_, std::strerror(errno));
}

void WholeFile::take_its_place() {
    if (std::fclose(std::exchange(stream_, nullptr)) != 0)
        fail_to_write(file_, std::strerror(errno));
    std::error_code error;
    const fs::file_status older = fs::status(target_, error);
    if (fs::is_regular_file(older)) fs::permissions(part_, older.permissions(), error);
    fs::rename(part_, target_, error);
    if (error) fail_to_write(file_, error.message());
    part_.clear();
}

void check_folder_of(const fs::path& file) {
    fs::path folder = behind_links(file).parent_path();
    std::error_code none;
    // Missing folders would be created.
    while (!folder.empty() && !fs::exists(fs::symlink_status(folder, none)))
        folder = folder.parent_path();
    if (!folder.empty() && !fs::is_directory(folder, none))
        throw InputError({folder.string()}, "is not a folder: expected one for " + file.string());
    fs::path part;
    std::fclose(open_part(folder, file, part));
    remove_part(part);
}

bool is_part_file(const fs::path& file) {
    const std::string name = file.filename().string();
    return name.size() == part_start.size() + part_digits + part_end.size() &&
           name.starts_with(part_start) && name.ends_with(part_end) &&
           name.find_first_not_of(hex_digits, part_start.size()) == part_start.size() + part_digits;
}

}  // namespace rt
