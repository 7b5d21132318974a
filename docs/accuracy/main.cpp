// accuracy_page <folder>           writes the plots and the page's tables, from the CSV there
// accuracy_page <folder> --check   fails, and names them, if any is not what it would write
//
// The folder is docs: the page is accuracy.md in it, the rest is in accuracy/.
#include "docs/accuracy/page.hpp"

#include "common/input_error.hpp"

#include <fstream>
#include <iostream>
#include <iterator>

namespace {

namespace fs = std::filesystem;

using namespace rt::accuracy;

std::string read(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// The page with the table between its two markers, in place of what stands there.
std::string with_table(const std::string& page, const Table& table) {
    const std::string begin = "<!-- table " + table.name + " -->\n";
    const std::string end = "<!-- end of " + table.name + " -->\n";
    const std::size_t from = page.find(begin);
    const std::size_t to = page.find(end);
    if (from == std::string::npos || to == std::string::npos)
        throw rt::InputError({.file = "accuracy.md"}, "has no place for the table " + table.name);
    return page.substr(0, from + begin.size()) + table.text + page.substr(to);
}

/// Writes the file, or says whether it would be another.
bool keep(const fs::path& file, const std::string& text, bool check) {
    if (read(file) == text) return true;
    if (check) {
        std::cerr << file.string() << " is not what the CSV beside it gives\n";
        return false;
    }
    std::ofstream out(file, std::ios::binary);
    out << text << std::flush;
    if (!out) throw rt::InputError({.file = file.string()}, "cannot be written");
    return true;
}

bool make(const fs::path& folder, bool check) {
    bool whole = true;
    std::string page = read(folder / "accuracy.md");
    for (const auto& study :
         {shapes, contact, penumbra, mirrors, meshes, pictures, input_rounding, choices}) {
        const Study made = study(folder / "accuracy");
        for (const Plot& plot : made.plots)
            whole &= keep(folder / "accuracy" / (plot.name + ".svg"), plot.source, check);
        for (const Table& table : made.tables) page = with_table(page, table);
    }
    return keep(folder / "accuracy.md", page, check) && whole;
}

}  // namespace

int main(int count, char** arguments) {
    if (count < 2) {
        std::cerr << "usage: accuracy_page <folder> [--check]\n";
        return 2;
    }
    try {
        return make(arguments[1], count > 2) ? 0 : 1;
    } catch (const rt::InputError& error) {
        std::cerr << error.what() << '\n';
        return 2;
    }
}
