#include "common/contract/files.hpp"

#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

namespace rt::contract {

std::string content_of(const std::string& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) throw std::runtime_error("cannot read " + file);
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::string sentence_in(const std::string& file) {
    constexpr std::string_view mark = "// sentence: ";
    std::istringstream lines(content_of(file));
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with(mark)) return line.substr(mark.size());
    throw std::runtime_error(file + " has no sentence");
}

}  // namespace rt::contract
