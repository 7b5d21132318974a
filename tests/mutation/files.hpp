// Whole files, read and written.
#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

namespace mutation {

/// Throws std::runtime_error if it cannot be read.
[[nodiscard]] inline std::string content_of(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) throw std::runtime_error("cannot read " + file.string());
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// Throws std::runtime_error if it cannot be written.
inline void write(const std::filesystem::path& file, const std::string& content) {
    std::ofstream stream(file, std::ios::binary);
    if (!(stream << content).flush()) throw std::runtime_error("cannot write " + file.string());
}

}  // namespace mutation
