// The names of students in a lecturer's files.
#pragma once

#include "common/system/input_error.hpp"
#include "common/system/text.hpp"

#include <map>
#include <optional>
#include <set>
#include <string>

namespace rt::grade {

using Students = std::set<std::string>;

/// Letters and digits, as plain_name leaves them: "Zoe Doe" is "zoe_doe". Without case, and an
/// accent is part of its letter, however it is encoded: "ZOÉ" and "Zoe" + U+0301 are "zoé".
[[nodiscard]] std::string folded(const std::string& name);

/// The number that a name ends with: "Participant 123", "doezoe_123"; or nothing.
[[nodiscard]] std::string number_at_end(const std::string& name);

/// The only one; nothing of none. Throws InputError if there are several.
[[nodiscard]] std::optional<std::string> only(const Students& matches, const std::string& name,
                                              const FileLocation& place);

/// Finds students of the results by their names in the lecturer's files.
class StudentNames {
public:
    StudentNames() = default;
    explicit StudentNames(const Students& students);

    /// Another name of the student.
    void add(const std::string& name, const std::string& student);

    [[nodiscard]] Students named(const std::string& name) const;

    /// By the number that a platform puts after a name: "123" of "Zoe_Doe_123".
    [[nodiscard]] Students numbered(const std::string& number) const;

    /// By the name before that number.
    [[nodiscard]] Students unnumbered(const std::string& name) const;

    /// By the name, the number, or the name without the number, whichever is the first to fit.
    /// Throws InputError if several students match.
    [[nodiscard]] std::optional<std::string> find(const std::string& name,
                                                  const FileLocation& place) const;

private:
    std::map<std::string, Students> by_name_;
    std::map<std::string, Students> by_number_;
    std::map<std::string, Students> by_bare_name_;
};

}  // namespace rt::grade
