#include "tests/mutation/survivors.hpp"

#include "tests/mutation/files.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace mutation {

namespace {

/// The texts before and after the first occurrence of a mark.
std::pair<std::string, std::string> parted(const std::string& line, const std::string& mark) {
    const std::size_t at = line.find(mark);
    if (at == std::string::npos) return {line, ""};
    return {line.substr(0, at), line.substr(at + mark.size())};
}

}  // namespace

std::vector<Survivor> read_survivors(const std::filesystem::path& file) {
    std::istringstream lines(content_of(file));
    std::vector<Survivor> survivors;
    Survivor next;
    std::size_t without_reason = 0;  // the first one
    for (std::string line; std::getline(lines, line);) {
        if (line.empty() || line.starts_with("#")) continue;
        if (line.starts_with("- ")) {
            next.before = line.substr(2);
        } else if (line.starts_with("+ ")) {
            next.after = line.substr(2);
            survivors.push_back(next);
        } else if (line.starts_with("step")) {
            std::tie(next.stage, next.function) = parted(line, " ");
        } else if (line.starts_with("equivalent: ") || line.starts_with("accuracy: ")) {
            for (; without_reason < survivors.size(); ++without_reason)
                std::tie(survivors[without_reason].kind, survivors[without_reason].reason) =
                    parted(line, ": ");
        } else {
            throw std::runtime_error(file.string() + ": what is this? " + line);
        }
    }
    if (without_reason < survivors.size())
        throw std::runtime_error(file.string() + ": no reason for " + next.after);
    return survivors;
}

const Survivor* find(const std::vector<Survivor>& survivors, const std::string& stage,
                     const Mutant& mutant) {
    const auto found = std::find_if(survivors.begin(), survivors.end(), [&](const Survivor& one) {
        return one.stage == stage && one.function == mutant.function &&
               one.before == mutant.before && one.after == mutant.after;
    });
    return found == survivors.end() ? nullptr : &*found;
}

}  // namespace mutation
