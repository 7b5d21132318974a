// Additions to the report of a failure.
#pragma once

#include "common/system/hash.hpp"

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
    void clear() { value_ = fnv1a(""); }
    void add(std::string_view failure) { value_ = fnv1a(failure, value_); }
    [[nodiscard]] std::uint64_t value() const { return value_; }

private:
    std::uint64_t value_ = fnv1a("");
};

inline FailureDigest failures_of_case;

}  // namespace rt
