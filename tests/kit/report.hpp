// Additions to the report of a failure.
#pragma once

#include "common/system/hash.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <set>
#include <string>
#include <string_view>

namespace rt {

/// Returns lines for the end of a failure, or an empty text. If there are lines, the failure's line
/// to paste is left out, since it would belong to another query.
inline std::function<std::string()> remark_on_failure;

/// Called at the first failure of a case.
inline std::function<void()> at_first_failure;

/// The failures of the case so far: of each, the digest of the question and that of the wrong
/// answer to it, "1f00aa64e1b2".
class Failures {
public:
    void clear() { digests_.clear(); }

    /// A failure in sentences, of which the line that begins with "got:" is the answer.
    void add(std::string_view failure) {
        std::uint64_t question = fnv1a("");
        std::uint64_t answer = question;
        while (!failure.empty()) {
            const std::string_view line = failure.substr(0, failure.find('\n'));
            failure.remove_prefix(std::min(line.size() + 1, failure.size()));
            const std::string_view words =
                line.substr(std::min(line.find_first_not_of(' '), line.size()));
            std::uint64_t& hash = words.starts_with("got:") ? answer : question;
            hash = fnv1a(words, hash);
        }
        char digits[16];
        std::snprintf(digits, sizeof digits, "%08x%04x", unsigned(question >> 32),
                      unsigned(answer >> 48));
        digests_.insert(digits);
    }

    /// In order, separated by blanks.
    [[nodiscard]] std::string text() const {
        std::string all;
        for (const std::string& each : digests_) all += (all.empty() ? "" : " ") + each;
        return all;
    }

private:
    std::set<std::string> digests_;
};

inline Failures failures_of_case;

}  // namespace rt
