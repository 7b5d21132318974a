#include "common/course/grade/reports/reports.hpp"

#include "common/course/grade/reports/html.hpp"
#include "common/course/grade/results/submissions.hpp"
#include "common/stages/stages.hpp"
#include "common/system/files.hpp"
#include "common/system/translation.hpp"

#include <algorithm>

namespace rt::grade {

namespace {

std::string preformatted(const std::string& words, const std::string& kind = "") {
    if (words.empty()) return "";
    const std::string start = kind.empty() ? "<pre>" : "<pre class=\"" + kind + "\">";
    return start + escaped(words.substr(0, words.find_last_not_of('\n') + 1)) + "</pre>\n";
}

std::string folded(const std::string& summary, const std::string& inside) {
    return "<details><summary>" + summary + "</summary>\n" + inside + "</details>\n";
}

/// In the page itself, so that it is one file.
std::string drawing(const fs::path& file, const std::string& caption) {
    std::error_code none;
    std::string image;
    if (fs::is_regular_file(fs::symlink_status(file, none)))
        image =
            "<img src=\"" +
            (file.extension() == ".svg" ? data_address("image/svg+xml", tr_lines(read_text(file)))
                                        : data_address("image/png", read_text(file))) +
            "\" alt=\"" + caption + "\"/>\n";
    return "<figure>" + image + "<figcaption>" + caption + "</figcaption></figure>\n";
}

std::string of_points(int points, int most) {
    return tr("{points} of {most}", {{"points", points}, {"most", counted(most, "point")}});
}

std::string failed_case(const CaseMark& each) {
    return "<h3>" + escaped(tr(each.name)) + " <small>" + (each.of_trace ? "main.cpp, " : "") +
           counted(each.points, "point") + "</small></h3>\n" +
           preformatted(tr_lines(each.words), "wrong") + "<small>" + escaped(each.place) +
           "</small>\n";
}

std::string diagnosis(const Mark& mark, const fs::path& folder) {
    std::string html;
    for (const std::string& sentence : lines_of(mark.mistake))
        html += "<p class=\"hint\">" +
                tr("Its answers are those of a known mistake: {sentence}",
                   {{"sentence", escaped(tr_text(sentence))}}) +
                "</p>\n";
    if (!mark.smallest.empty())
        html += "<h3>" + tr("The simplest failing input") + "</h3>\n" +
                preformatted(tr_lines(mark.smallest), "wrong");
    if (!mark.slice.empty()) html += drawing(folder / mark.slice, tr("A drawing of it"));
    return html;
}

std::string picture(const PictureMark& picture, const fs::path& folder) {
    const Values values = {{"number", picture.different},
                           {"pixels", counted(picture.pixels, "pixel")}};
    const std::string caption =
        picture.different == 0
            ? tr("With your stages up to this one, with the references, and the difference: none "
                 "of {pixels} differs",
                 values)
            : tr("With your stages up to this one, with the references, and the difference: "
                 "{number} of {pixels} differ",
                 values);
    return drawing(folder / picture.file, caption);
}

std::string judged(const Mark& mark, const fs::path& folder) {
    std::string failed;
    std::string passed;
    int passes = 0;
    for (const CaseMark& each : mark.cases) {
        if (!each.passed) failed += failed_case(each);
        if (each.passed) passed += "<li>" + escaped(tr(each.name)) + "</li>\n";
        if (each.passed) ++passes;
    }
    const int fails = int(mark.cases.size()) - passes;
    std::string html;
    if (fails > 0)
        html = "<p>" +
               tr(fails == 1 ? to_translate("{cases} of {all} fails.")
                             : to_translate("{cases} of {all} fail."),
                  {{"cases", counted(fails, "case")}, {"all", mark.cases.size()}}) +
               "</p>\n";
    if (passes > 0 && mark.points() == 0)
        html += "<p>" +
                tr("All passing cases pass in the starter too: they count as soon as anything else "
                   "passes.") +
                "</p>\n";
    html += diagnosis(mark, folder) + failed;
    const bool differs = mark.picture && mark.picture->different > 0;
    if (differs) html += "<h3>" + tr("Your picture") + "</h3>\n" + picture(*mark.picture, folder);
    if (mark.picture && !differs)
        html += folded(tr("Your picture is right"), picture(*mark.picture, folder));
    const std::string what_passes =
        fails == 0 && mark.untested_points() == 0
            ? tr("Every case passes")
            : tr(passes == 1 ? to_translate("{cases} passes") : to_translate("{cases} pass"),
                 {{"cases", counted(passes, "case")}});
    if (passes > 0) html += folded(what_passes, "<ul>\n" + passed + "</ul>\n");
    if (mark.untested_points() > 0)
        html += "<h3>" +
                tr("A file is missing, or cannot be graded: {points}",
                   {{"points", counted(mark.untested_points(), "point")}}) +
                "</h3>\n" + preformatted(tr_lines(mark.words), "wrong");
    else if (!mark.words.empty())
        html += folded(tr("Messages about your files"), preformatted(tr_lines(mark.words)));
    return html;
}

std::string section(const Mark& mark, int most, const fs::path& folder) {
    const std::string html = "<section id=\"" + name_of(mark.stage) +
                             "\">\n<div class=\"line\"><h2>" + stage_title(mark.stage) +
                             "</h2> <span>" + of_points(mark.points(), most) + "</span></div>\n";
    if (mark.verdict == Verdict::missing)
        return html + "<p>" + tr("No file was submitted.") + "</p>\n" +
               preformatted(tr_lines(mark.words), "wrong") + "</section>\n";
    if (mark.verdict == Verdict::postponed)
        return html + "<p>" + escaped(tr_lines(mark.words)) + "</p>\n</section>\n";
    if (mark.verdict == Verdict::refused)
        return html + "<p>" + tr("Your file cannot be graded:") + "</p>\n" +
               preformatted(tr_lines(mark.words), "wrong") + "</section>\n";
    return html + judged(mark, folder) + "</section>\n";
}

/// The stages at a glance, each a link.
std::string overview(const StudentMarks& submission, const std::map<int, int>& stages) {
    std::string html = "<ul class=\"stages\">\n";
    for (const auto& [stage, mark] : submission.marks) {
        const int most = stages.at(stage);
        html += "<li><a class=\"share\" style=\"--share: " +
                std::to_string(100 * mark->points() / std::max(most, 1)) + "%\" href=\"#" +
                name_of(stage) + "\">" + stage_title(stage) + "<small>" +
                tr("{points} of {most}", {{"points", mark->points()}, {"most", most}}) +
                (submission.stages.count(stage) == 0 ? ", " + tr("excused") : "") +
                (mark->verdict == Verdict::missing     ? ", " + tr("not submitted")
                 : mark->verdict == Verdict::postponed ? ", " + tr("not graded yet")
                                                       : "") +
                "</small></a></li>\n";
    }
    return html + "</ul>\n";
}

}  // namespace

void write_feedback(const fs::path& results, const std::vector<Mark>& marks, const Term& term) {
    const std::map<int, int> stages = graded_stages(marks);
    remove_shared_feedback(results);
    for (const StudentMarks& submission : submissions(marks, term)) {
        if (submission.marks.empty()) continue;
        std::string body =
            "<header><h1>" + escaped(submission.called) + "</h1> <p>" +
            tr("{points} of {most}",
               {{"points", number_text(submission.points)}, {"most", points_text(submission.of)}}) +
            "</p></header>\n" + preformatted(submission.remarks) + overview(submission, stages);
        for (const auto& [stage, mark] : submission.marks)
            body += section(*mark, stages.at(stage), student_folder(results, mark->student));
        const fs::path folder = student_folder(results, submission.student);
        fs::create_directories(folder);  // of a student without an own submission
        write_text(folder / feedback_file, page(submission.called, body));
    }
}

}  // namespace rt::grade
