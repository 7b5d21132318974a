#include "common/system/files.hpp"

#include "common/system/input_error.hpp"
#include "common/system/translation.hpp"
#include "common/system/whole_file.hpp"

#include <unistd.h>  // mkdtemp on macOS

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace rt {

std::string read_text(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    if (in.peek() != std::ifstream::traits_type::eof()) text << in.rdbuf();  // fails on nothing
    if (in.bad() || !in.is_open() || !text) throw InputError({file.string()}, "cannot be read");
    return text.str();
}

std::vector<std::string> lines_in(const fs::path& file) {
    return fs::exists(file) ? lines_of(read_text(file)) : std::vector<std::string>();
}

void write_text(const fs::path& file, const std::string& text) {
    WholeFile whole(file);
    whole.write(text);
    whole.take_its_place();
}

void copy_whole(const fs::path& from, const fs::path& to) {
    WholeFile whole(to);
    whole.write(read_text(from));
    whole.take_its_place();
    fs::permissions(to, fs::status(from).permissions() | fs::perms::owner_write);
}

std::vector<fs::path> files_in(const fs::path& folder, const std::string& ending) {
    std::vector<fs::path> files;
    std::error_code none;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, none))
        if (entry.path().extension() == ending) files.push_back(entry.path());
    std::ranges::sort(files);
    return files;
}

fs::path temporary_place() {
    std::error_code error;
    fs::path place = fs::temp_directory_path(error);
    if (error) throw InputError({}, "the variable TMPDIR must be the name of a folder");
    return place;
}

fs::path make_folder(const fs::path& parent, const std::string& start) {
    std::string name = parent / (start + "XXXXXX");  // completed by mkdtemp
    if (mkdtemp(name.data()) == nullptr) throw InputError({name}, "cannot be created");
    return name;
}

bool is_free_for_folder(const fs::path& path) {
    const fs::file_type type = fs::symlink_status(path).type();
    return type == fs::file_type::not_found ||
           (type == fs::file_type::directory && fs::is_empty(path));
}

void refuse_what_is_there(const fs::path& typed, const fs::path& path) {
    if (!is_free_for_folder(path))
        throw InputError({typed.string()},
                         tr("exists already: expected a new name, or an empty folder"));
}

TemporaryFolder::TemporaryFolder(const fs::path& parent, const std::string& start)
    : path_(make_folder(parent, start)) {}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

}  // namespace rt
