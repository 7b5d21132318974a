#include "common/course/grade/results/student_names.hpp"

#include <utf8proc.h>

#include <cstdlib>
#include <memory>

namespace rt::grade {

namespace {

Students found(const std::map<std::string, Students>& all, const std::string& key) {
    const auto at = all.find(key);
    return at == all.end() ? Students{} : at->second;
}

}  // namespace

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

std::optional<std::string> only(const Students& matches, const std::string& name,
                                const FileLocation& place) {
    if (matches.empty()) return std::nullopt;
    if (matches.size() == 1) return *matches.begin();
    throw InputError(place,
                     "\"" + name + "\" may be " + joined(matches) + ": write one of these names");
}

StudentNames::StudentNames(const Students& students) {
    for (const std::string& student : students) add(student, student);
    for (const std::string& student : students) {
        const std::size_t line = student.rfind('_');
        const std::string number = number_at_end(student);
        const bool is_numbered = !number.empty() && line != std::string::npos &&
                                 line + 1 + number.size() == student.size();
        // The grader itself numbers the second of two students with one name.
        if (!is_numbered || !named(student.substr(0, line)).empty()) continue;
        by_number_[number].insert(student);
        by_bare_name_[folded(student.substr(0, line))].insert(student);
    }
}

void StudentNames::add(const std::string& name, const std::string& student) {
    if (!name.empty()) by_name_[folded(name)].insert(student);
}

Students StudentNames::named(const std::string& name) const {
    return found(by_name_, folded(name));
}

Students StudentNames::numbered(const std::string& number) const {
    return found(by_number_, number);
}

Students StudentNames::unnumbered(const std::string& name) const {
    return found(by_bare_name_, folded(name));
}

std::optional<std::string> StudentNames::find(const std::string& name,
                                              const FileLocation& place) const {
    for (const Students& matches : {named(name), numbered(trimmed(name)), unnumbered(name)})
        if (!matches.empty()) return only(matches, name, place);
    return std::nullopt;
}

}  // namespace rt::grade
