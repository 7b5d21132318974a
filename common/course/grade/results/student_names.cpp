#include "common/course/grade/results/student_names.hpp"

#include <utf8proc.h>

#include <cstdlib>
#include <memory>

namespace rt::grade {

namespace {

/// The only match. Throws InputError if there are several.
std::string only(const std::set<std::string>& matches, const std::string& name,
                 const FileLocation& place) {
    if (matches.size() == 1) return *matches.begin();
    std::string all;
    for (const std::string& student : matches) all += (all.empty() ? "" : ", ") + student;
    throw InputError(place, "\"" + name + "\" may be " + all + ": write one of these names");
}

}  // namespace

std::string trimmed(const std::string& text) {
    const std::size_t first = text.find_first_not_of(" \t\r");
    if (first == std::string::npos) return "";
    return text.substr(first, text.find_last_not_of(" \t\r") + 1 - first);
}

std::string folded(const std::string& name) {
    const std::unique_ptr<utf8proc_uint8_t, decltype(&std::free)> small(
        utf8proc_NFKC_Casefold(reinterpret_cast<const utf8proc_uint8_t*>(trimmed(name).c_str())),
        &std::free);
    // Bytes that are no UTF-8 have no case.
    std::string text = small ? reinterpret_cast<const char*>(small.get()) : trimmed(name);
    for (char& c : text) {
        const bool kept = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '.' ||
                          c == '-' || static_cast<unsigned char>(c) >= 0x80;
        if (!kept) c = '_';
    }
    return text;
}

std::string number_at_end(const std::string& name) {
    const std::size_t last = name.find_last_not_of("0123456789");
    return name.substr(last == std::string::npos ? 0 : last + 1);
}

StudentNames::StudentNames(const std::vector<Mark>& marks) {
    std::set<std::string> all;
    for (const Mark& mark : marks) all.insert(mark.student);
    for (const std::string& student : all) {
        add(student, student);
        const std::size_t line = student.rfind('_');
        const std::string number = number_at_end(student);
        const bool is_numbered = !number.empty() && line != std::string::npos &&
                                 line + 1 + number.size() == student.size();
        // The grader itself numbers the second of two students with one name.
        if (is_numbered && all.count(student.substr(0, line)) == 0)
            by_number_[number].insert(student);
    }
}

void StudentNames::add(const std::string& name, const std::string& student) {
    if (!name.empty()) by_name_[folded(name)].insert(student);
}

std::optional<std::string> StudentNames::find(const std::string& name,
                                              const FileLocation& place) const {
    if (const auto found = by_name_.find(folded(name)); found != by_name_.end())
        return only(found->second, name, place);
    const std::string number = trimmed(name);
    return number_at_end(number) == number ? find_number(number, name, place) : std::nullopt;
}

std::optional<std::string> StudentNames::find_identifier(const std::string& identifier,
                                                         const FileLocation& place) const {
    if (const auto found = find(identifier, place)) return found;
    return find_number(number_at_end(trimmed(identifier)), identifier, place);
}

std::optional<std::string> StudentNames::find_number(const std::string& number,
                                                     const std::string& name,
                                                     const FileLocation& place) const {
    const auto found = by_number_.find(number);
    if (found == by_number_.end()) return std::nullopt;
    return only(found->second, name, place);
}

}  // namespace rt::grade
