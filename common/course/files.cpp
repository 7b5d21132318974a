#include "common/course/files.hpp"

#include "common/input_error.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace rt {

namespace fs = std::filesystem;

std::string read_text(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    if (in.peek() != std::ifstream::traits_type::eof()) text << in.rdbuf();  // fails on nothing
    if (in.bad() || !in.is_open() || !text) throw InputError({file.string()}, "cannot be read");
    return text.str();
}

void write_text(const fs::path& file, const std::string& text) {
    const fs::path beside = file.parent_path() / ("." + file.filename().string() + ".new");
    std::error_code failed;
    {
        std::ofstream out(beside, std::ios::binary);
        out << text;
        out.close();
        if (!out) failed = std::make_error_code(std::errc::io_error);
    }
    if (!failed) fs::rename(beside, file, failed);
    if (!failed) return;
    std::error_code ignored;
    fs::remove(beside, ignored);
    throw InputError({file.string()},
                     "cannot be written: is the disk full, or the folder not yours?");
}

std::vector<fs::path> files_in(const fs::path& folder, const std::string& ending) {
    std::vector<fs::path> files;
    std::error_code none;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, none))
        if (entry.path().extension() == ending) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

TemporaryFolder::TemporaryFolder(const fs::path& parent) {
    std::string name = parent / "raysteps.XXXXXX";  // which mkdtemp fills in
    if (mkdtemp(name.data()) == nullptr) throw InputError({name}, "cannot be made");
    path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

}  // namespace rt
