#include "common/contract/files.hpp"

#include <fstream>
#include <iterator>
#include <stdexcept>

namespace rt::contract {

std::string content_of(const std::string& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) throw std::runtime_error("cannot read " + file);
    return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace rt::contract
