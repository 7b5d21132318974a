#include "common/course/grade/grade_book.hpp"

#include "common/course/files.hpp"
#include "common/course/grade/html.hpp"
#include "common/course/grade/submissions.hpp"
#include "common/stages.hpp"

namespace rt::grade {

namespace {

constexpr const char* end_of_line = "\r\n";  // RFC 4180 has it so

/// Also in full width, and after blanks: some spreadsheets read these alike.
bool is_formula(std::string_view text) {
    text.remove_prefix(std::min(text.find_first_not_of(" \t\n"), text.size()));
    for (const std::string_view start : {"=", "+", "-", "@", "＝", "＋", "－", "＠"})
        if (text.starts_with(start)) return true;
    return false;
}

}  // namespace

std::string cell(const std::string& text) {
    std::string plain = readable(text);
    if (is_formula(plain)) plain.insert(0, "'");
    if (plain.find_first_of(",;\"\n\t") == std::string::npos) return plain;
    for (std::size_t at = plain.find('"'); at != std::string::npos; at = plain.find('"', at + 2))
        plain.insert(at, "\"");
    return "\"" + plain + "\"";
}

void write_grade_book(const std::filesystem::path& results, const std::vector<Mark>& marks) {
    const std::map<int, int> stages = graded_stages(marks);
    std::string book = "student";
    for (const auto& [stage, most] : stages) book += "," + std::string(stage_name(stage));
    book += std::string(",total,of") + end_of_line;
    for (const Submission& submission : submissions(marks)) {
        book += cell(submission.student);
        for (const auto& [stage, most] : stages) {
            const auto mark = submission.marks.find(stage);
            const int points = mark == submission.marks.end() ? 0 : mark->second->points();
            book += "," + std::to_string(points);
        }
        book += "," + std::to_string(submission.points()) + "," +
                std::to_string(most_points(stages)) + end_of_line;
    }
    write_text(results / "grades.csv", book);
}

}  // namespace rt::grade
