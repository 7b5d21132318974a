// The names of students in a lecturer's files.
#pragma once

#include "common/course/grade/results/results.hpp"
#include "common/system/input_error.hpp"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace rt::grade {

/// The text without blanks at its ends.
[[nodiscard]] std::string trimmed(const std::string& text);

/// Letters and digits, as plain_name leaves them: "Zoe Doe" is "zoe_doe". Without case, and an
/// accent is part of its letter, however it is encoded: "ZOÉ" and "Zoe" + U+0301 are "zoé".
[[nodiscard]] std::string folded(const std::string& name);

/// The number that a name ends with: "Participant 123", "doezoe_123"; or nothing.
[[nodiscard]] std::string number_at_end(const std::string& name);

/// Finds students of the results by their names in the lecturer's files.
class StudentNames {
public:
    explicit StudentNames(const std::vector<Mark>& marks);

    void add(const std::string& name, const std::string& student);

    /// By the name, or by the number alone. Throws InputError if several students match.
    [[nodiscard]] std::optional<std::string> find(const std::string& name,
                                                  const FileLocation& place) const;

    /// The same for the identifiers of a platform, "Participant 123", whose number decides.
    [[nodiscard]] std::optional<std::string> find_identifier(const std::string& identifier,
                                                             const FileLocation& place) const;

private:
    [[nodiscard]] std::optional<std::string> find_number(const std::string& number,
                                                         const std::string& name,
                                                         const FileLocation& place) const;

    std::map<std::string, std::set<std::string>> by_name_;
    std::map<std::string, std::set<std::string>> by_number_;
};

}  // namespace rt::grade
