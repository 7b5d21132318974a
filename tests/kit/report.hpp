// Additions to the report of a failure.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace rt {

/// Returns lines for the end of a failure, or an empty text. If there are lines, the failure's line
/// to paste is left out, since it would belong to another query.
inline std::function<std::string()> remark_on_failure;

/// The digest of all failures of the case so far, each with its question and the wrong answer.
class FailureDigest {
public:
    void clear() { state_ = start; }
    void add(std::string_view failure) {
        for (const char letter : failure)  // FNV-1a, of 64 bits
            state_ = (state_ ^ static_cast<unsigned char>(letter)) * 0x100000001b3;
    }
    [[nodiscard]] std::uint64_t value() const { return state_; }

private:
    static constexpr std::uint64_t start = 0xcbf29ce484222325;
    std::uint64_t state_ = start;
};

inline FailureDigest failures_of_case;

}  // namespace rt
