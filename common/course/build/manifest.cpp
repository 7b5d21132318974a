#include "common/course/build/manifest.hpp"

#include "common/system/input_error.hpp"

#include <cstdint>

namespace rt {

bool Manifest::matches(const fs::path& folder, const std::string& path) const {
    const auto known = fingerprints.find(path);
    return known != fingerprints.end() &&
           fs::symlink_status(folder / path).type() == fs::file_type::regular &&
           known->second.count(fingerprint(folder / path)) > 0;
}

bool is_handout(const fs::path& folder) {
    std::error_code none;
    return fs::is_regular_file(folder / manifest_file, none);
}

Manifest read_manifest(const fs::path& folder) {
    const auto refuse = [&folder] {
        throw InputError({folder.string()},
                         "not a hand-out of Raysteps, as written by ./course handout");
    };
    if (!is_handout(folder)) refuse();
    Manifest manifest;
    for (const std::string& line : lines_of(read_text(folder / manifest_file))) {
        const std::size_t space = line.find(' ', line.find(' ') + 1);
        if (space == std::string::npos) refuse();
        if (manifest.title.empty())
            manifest.title = line;
        else
            manifest.fingerprints[line.substr(space + 1)].insert(line.substr(0, space));
    }
    if (manifest.title.rfind("Raysteps, ", 0) != 0 || manifest.fingerprints.empty()) refuse();
    return manifest;
}

void write_manifest(const fs::path& folder, const Manifest& manifest) {
    std::string text = manifest.title + "\n";
    for (const auto& [path, fingerprints] : manifest.fingerprints)
        for (const std::string& fingerprint : fingerprints) text += fingerprint + " " + path + "\n";
    write_text(folder / manifest_file, text);
}

std::string fingerprint(const fs::path& file) {
    const std::string text = read_text(file);
    std::uint32_t crc = 0;
    const auto take = [&crc](std::size_t byte) {
        crc ^= std::uint32_t(byte) << 24;
        for (int bit = 0; bit < 8; ++bit)
            crc = (crc << 1) ^ ((crc & 0x80000000u) != 0 ? 0x04c11db7u : 0);
    };
    for (const char c : text) take(static_cast<unsigned char>(c));
    for (std::size_t length = text.size(); length > 0; length >>= 8) take(length & 0xff);
    return std::to_string(~crc) + " " + std::to_string(text.size());
}

}  // namespace rt
