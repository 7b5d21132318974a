// The reports on a class's marks, with numbers computed by hand.
#include "common/course/grade/reports/reports.hpp"
#include "common/course/grade/reports/html.hpp"
#include "common/course/grade/results/csv.hpp"
#include "common/course/grade/results/submissions.hpp"
#include "common/course/grade/results/winnowing.hpp"
#include "common/stages/reasons.hpp"
#include "common/stages/stages.hpp"
#include "common/system/escaping.hpp"
#include "common/system/files.hpp"
#include "common/system/translation.hpp"

#include "tests/grading/reports_class.hpp"
#include "tests/kit/catch.hpp"

#include <regex>

namespace rt::grade {

namespace {

namespace fs = std::filesystem;

struct ClassOfTwo : Results {
    ClassOfTwo() {
        for (const Mark& mark : class_of_two()) write_mark(folder, mark);
        marks = read_marks(folder);
    }

    std::vector<Mark> marks;
};

/// True if the tags are balanced, and the text contains no bare "<" or "&".
bool well_formed(const std::string& xml) {
    static const std::regex token(
        R"(<(/?)([A-Za-z0-9]+)((?: [a-z-]+="[^"<]*")*)(/?)>|<[!?][^<>]*>|)"
        R"(&(?:lt|gt|amp|quot|#39);|[^<&])");
    std::vector<std::string> open;
    std::ptrdiff_t end = 0;
    for (std::sregex_iterator each(xml.begin(), xml.end(), token), none; each != none; ++each) {
        if (each->position() != end) return false;
        end += each->length();
        const std::string name = (*each)[2];
        const bool closes = (*each)[1].length() > 0;
        if (name.empty() || (*each)[4].length() > 0) continue;
        if (closes && (open.empty() || open.back() != name)) return false;
        if (closes)
            open.pop_back();
        else
            open.push_back(name);
    }
    return open.empty() && end == std::ptrdiff_t(xml.size());
}

}  // namespace

TEST_CASE("text that everybody can read is UTF-8 without control characters") {
    CHECK(readable("a\tb\nc\r\nd §→") == "a\tb\nc\nd §→");
    CHECK(readable("a\x01\x7f\rb") == "a���b");
    CHECK(readable("\xff") == "�");
    CHECK(readable("\xc3") == "�");
    CHECK(readable("\xc0\x80") == "��");  // overlong encoding
    CHECK(readable("\xe0\x80\xaf") == "���");
    CHECK(readable("\xed\xa0\x80") == "���");              // half a pair of UTF-16
    CHECK(readable("\xf8\x90\x80\x80") == "����");         // above Unicode's maximum
    CHECK(readable("\xef\xbf\xbf") == "���");              // not in XML
    CHECK(readable("1\xe2\x80\xae of 9") == "1��� of 9");  // turns the direction of writing
    CHECK(readable("\xf0\x9f\x8e\xa8") == "\xf0\x9f\x8e\xa8");
}

TEST_CASE("strangers' text is text in a page") {
    CHECK(escaped("<b a='1'>\"&amp;\"") == "&lt;b a=&#39;1&#39;&gt;&quot;&amp;amp;&quot;");
    CHECK(well_formed("<p>a &lt; b<br/></p>"));
    CHECK_FALSE(well_formed("<p>a < b</p>"));
    CHECK_FALSE(well_formed("<p>a & b</p>"));
    CHECK_FALSE(well_formed("<p><b></p></b>"));
    CHECK_FALSE(well_formed("<p>"));
}

TEST_CASE("a share is rounded down: only what is whole is 100 %") {
    CHECK(percent(199, 200) == "99 %");
    CHECK(percent(3, 3) == "100 %");
    CHECK(percent(0, 3) == "0 %");
    CHECK(percent(0, 0) == "");
}

TEST_CASE("a cell of the grade book is no formula, and keeps to itself") {
    CHECK(cell("anna") == "anna");
    CHECK(cell("Martin, Léa") == "\"Martin, Léa\"");
    CHECK(cell("the \"fast\" one") == "\"the \"\"fast\"\" one\"");
    CHECK(cell("two\nlines") == "\"two\nlines\"");
    CHECK(cell("=1+1") == "'=1+1");
    CHECK(cell("+1") == "'+1");
    CHECK(cell("-1") == "'-1");
    CHECK(cell("@SUM") == "'@SUM");
    CHECK(cell("  =1") == "'  =1");
    CHECK(cell("\t=1") == "\"'\t=1\"");
    CHECK(cell("＝1") == "'＝1");
    CHECK(cell("a=1-2") == "a=1-2");
    CHECK(cell("") == "");
}

TEST_CASE("the grade book has a line a student") {
    const ClassOfTwo two;
    write_grade_book(two.folder, two.marks);
    CHECK(read_text(two.folder / "grades.csv") ==
          "student,step04_plane,step05_triangle,total,of,remarks\r\n"
          "\"'=cmd|\"\"<b>&\n\",1,0,1,6,\r\n"
          "zoe,0,3,3,6,<none>\r\n");
}

TEST_CASE("the grade book contains the reasons why stages have no file, each once") {
    const Results results;
    const std::vector<Mark> marks{
        {.student = "anna",
         .stage = 3,
         .words = "The archive a.rar cannot be opened.\nx",
         .most = 2},
        {.student = "ben", .stage = 3, .most = 2},
        {.student = "carl",
         .stage = 3,
         .verdict = Verdict::judged,
         .words = "a warning",
         .most = 2},
        {.student = "carl", .stage = 4, .words = "There is no plane.cpp.\n", .most = 1},
        {.student = "carl", .stage = 5, .words = "There is no plane.cpp.\n", .most = 1}};
    write_grade_book(results.folder, marks);
    CHECK(read_text(results.folder / "grades.csv") ==
          "student,step03_sphere,step04_plane,step05_triangle,total,of,remarks\r\n"
          "anna,0,0,0,0,4,The archive a.rar cannot be opened.\r\n"
          "ben,0,0,0,0,4,\r\n"
          "carl,0,0,0,0,4,There is no plane.cpp.\r\n");
}

TEST_CASE("JUnit's XML has a testsuite a student and stage") {
    const ClassOfTwo two;
    write_junit(two.folder, two.marks);
    const std::string xml = read_text(two.folder / "junit.xml");
    CHECK(well_formed(xml));
    const std::string name = "=cmd|&quot;&lt;b&gt;&amp;\n";
    CHECK(has(xml, "<testsuite name=\"" + name +
                       ".step04_plane\" tests=\"2\" failures=\"1\" errors=\"0\" skipped=\"0\">"));
    CHECK(has(xml, "name=\"it is hit\"/>"));
    CHECK(has(xml,
              "name=\"a &lt; b &amp; &quot;c&quot;\"><failure message=\"got: ��(\">"
              "tests/suites/step04_plane_test.cpp:9\ngot: ��(\nexpected: &lt;hit&gt;\n</failure>"));
    CHECK(has(xml, ".step05_triangle\" tests=\"1\" failures=\"0\" errors=\"1\" skipped=\"0\">"));
    CHECK(has(xml, "<error>no &lt;vec&gt;</error>"));
    CHECK(has(xml,
              "<testsuite name=\"zoe.step04_plane\" tests=\"1\" failures=\"0\" errors=\"0\" "
              "skipped=\"1\">"));
    CHECK(has(xml, "<skipped message=\"&lt;none&gt;\"/>"));
}

TEST_CASE("Gradescope gets one test per case, and one for a stage that was not graded") {
    const ClassOfTwo two;
    write_gradescope(two.folder / "results.json", {two.marks[2], two.marks[3]});
    const std::string same = R"(      "output_format": "text",
      "visibility": "visible"
    })";
    CHECK(read_text(two.folder / "results.json") == R"({
  "score": 3,
  "output": "",
  "output_format": "text",
  "visibility": "visible",
  "tests": [
    {
      "name": "4 plane",
      "score": 0,
      "max_score": 2,
      "status": "failed",
      "output": "No file was submitted.\n<none>",
)" + same + R"(,
    {
      "name": "5 triangle: edges",
      "score": 3,
      "max_score": 3,
      "status": "passed",
      "output": "",
)" + same + R"(,
    {
      "name": "5 triangle: a < b & \"c\"",
      "score": 0,
      "max_score": 1,
      "status": "failed",
      "output": "here:1\nno",
)" + same + "\n  ]\n}\n");

    const std::vector<Mark> unread = class_of_two();  // with bytes that are no UTF-8
    write_gradescope(two.folder / "results.json", {unread[0], unread[1]});
    const std::string json = read_text(two.folder / "results.json");
    CHECK(has(json, "\"output\": \"4 plane: You compare with <0>.\\n\\n\""));
    CHECK(has(json, "\"output\": \"Your file cannot be graded:\\nno <vec>\""));
}

TEST_CASE("a feedback page shows the failures, and folds away the passing stages") {
    const ClassOfTwo two;
    write_text(student_folder(two.folder, odd) / "step04 slice.svg", "<svg/>");
    write_text(student_folder(two.folder, odd) / "step04_plane.png", "\x89PNG");
    write_feedback(two.folder, two.marks);
    const std::string page = read_text(student_folder(two.folder, odd) / "feedback.html");
    CHECK(well_formed(page));
    CHECK_FALSE(has(page, "<script"));
    CHECK_FALSE(has(page, "<b>"));
    CHECK(has(page, "<h1>=cmd|&quot;&lt;b&gt;&amp;\n</h1> <p>1 of 6 points</p>"));
    CHECK(has(page, "<h2>4 plane</h2> <span>1 of 2 points</span>"));
    CHECK(has(page, "<p>1 case of 2 fails.</p>"));
    CHECK(has(page, "a known mistake: You compare with &lt;0&gt;.</p>"));
    CHECK(has(page, "<pre class=\"wrong\">intersect(…)\n  got: 1</pre>"));
    CHECK(has(page, "<img src=\"data:image/svg+xml;base64,PHN2Zy8+\""));
    CHECK(has(page,
              "<h3>a &lt; b &amp; &quot;c&quot; <small>1 point</small></h3>\n"
              "<pre class=\"wrong\">got: ��(\nexpected: &lt;hit&gt;</pre>\n"
              "<small>tests/suites/step04_plane_test.cpp:9</small>"));
    CHECK(has(page, "<h3>Your picture</h3>\n<figure><img src=\"data:image/png;base64,iVBORw==\""));
    CHECK(has(page, "the difference: 5 of 12 pixels differ"));
    CHECK(has(page, "<summary>1 case passes</summary>\n<ul>\n<li>it is hit</li>\n</ul>"));
    CHECK(has(page, "<pre>warning: &lt;unused&gt;</pre>"));
    CHECK(
        has(page, "<p>Your file cannot be graded:</p>\n<pre class=\"wrong\">no &lt;vec&gt;</pre>"));

    const std::string other = read_text(student_folder(two.folder, "zoe") / "feedback.html");
    CHECK(well_formed(other));
    CHECK(has(other, "<p>3 of 6 points</p>"));
    CHECK(has(other, "<p>No file was submitted.</p>\n<pre class=\"wrong\">&lt;none&gt;</pre>"));
    CHECK(has(other, "<details><summary>Your picture is right</summary>"));
}

TEST_CASE("a drawing's labels are in the language of the feedback") {
    const ClassOfTwo two;
    write_text(student_folder(two.folder, odd) / "step04 slice.svg", "<text>\nno hit\n</text>\n");
    write_text(two.folder / "xx.po", "msgid \"no hit\"\nmsgstr \"rien\"\n");
    read_translations(two.folder / "xx.po");
    write_feedback(two.folder, two.marks);
    forget_translations();
    CHECK(has(read_text(student_folder(two.folder, odd) / "feedback.html"),
              data_address("image/svg+xml", "<text>\nrien\n</text>\n")));
}

TEST_CASE("a submitted starter has no points, and the feedback gives the reason") {
    const Results results;
    const Mark mark{.student = "anna",
                    .stage = 3,
                    .verdict = Verdict::judged,
                    .cases = {{.name = "behind", .passed = true, .given = true}, {.name = "hit"}},
                    .most = 2};
    write_mark(results.folder, mark);
    write_feedback(results.folder, {mark});
    const std::string page = read_text(student_folder(results.folder, "anna") / "feedback.html");
    CHECK(has(page, "<span>0 of 2 points</span>"));
    CHECK(has(page, "<p>All passing cases pass in the starter too"));
    write_gradescope(results.folder / "results.json", {mark});
    const std::string json = read_text(results.folder / "results.json");
    CHECK(has(json, "\"score\": 0,\n      \"max_score\": 1,\n      \"status\": \"passed\""));
    CHECK_FALSE(has(json, "\"score\": 1"));
}

TEST_CASE("the class report has every mark, and the most important rows first") {
    ClassOfTwo two;
    // zoe's stage 5, submitted by two others, one of them with all points
    std::vector<Mark> more = two.marks;
    for (const std::string student : {"ben", "carl"}) {
        Mark mark = two.marks[3];
        mark.student = student;
        mark.mistake = "You take <a> for b.\nYou forget c.";
        mark.cases[1].passed = student == "carl";
        more.push_back(mark);
    }
    write_class_report(two.folder, RAYSTEPS_ROOT, more);
    const std::string page = read_text(two.folder / "class.html");
    CHECK(well_formed(page));
    CHECK(has(page, "4 students, 2 stages, 6 points"));
    CHECK(has(page,
              "<a href=\"students/%3Dcmd%7C%22%3Cb%3E%26%0A/feedback.html\">"
              "=cmd|&quot;&lt;b&gt;&amp;\n</a></th>"
              "<td class=\"share\" style=\"--share: 50%\">50</td>"
              "<td class=\"share\" style=\"--share: 0%\" title=\"cannot be graded\">×</td>"
              "<td class=\"share\" style=\"--share: 16%\">1</td>"));
    CHECK(has(page,
              "zoe</a></th><td class=\"soft\" title=\"not submitted\">–</td>"
              "<td class=\"share\" style=\"--share: 75%\">75</td>"
              "<td class=\"share\" style=\"--share: 50%\">3</td>"));
    // In stage 5, 0 + 3 + 3 + 4 of 16 points were reached.
    CHECK(has(page,
              "mean of submissions</th><td class=\"share\" style=\"--share: 50%\">50</td>"
              "<td class=\"share\" style=\"--share: 62%\">62</td>"));
    const std::size_t often = page.find(
        "--share: 66%\">2</td><td class=\"text\">5 triangle</td>"
        "<td class=\"text\">You take &lt;a&gt; for b.</td>");
    CHECK(has(page,
              "--share: 66%\">2</td><td class=\"text\">5 triangle</td>"
              "<td class=\"text\">You forget c.</td>"));
    const std::size_t once = page.find(
        "--share: 100%\">1</td><td class=\"text\">4 plane</td>"
        "<td class=\"text\">You compare with &lt;0&gt;.</td>");
    CHECK(often < once);
    CHECK(once != std::string::npos);
    const std::size_t hardest = page.find(
        "0 %</td><td>1</td><td class=\"text\">4 plane</td>"
        "<td class=\"text\">a &lt; b &amp; &quot;c&quot;</td>");
    const std::size_t less_hard = page.find(
        "33 %</td><td>3</td><td class=\"text\">5 triangle</td>"
        "<td class=\"text\">a &lt; b &amp; &quot;c&quot;</td>");
    CHECK(hardest < less_hard);
    CHECK(less_hard != std::string::npos);
    CHECK_FALSE(has(page, "it is hit"));
    CHECK(has(page, "Similarity is no proof."));
}

TEST_CASE("bytes are an address of their own, as RFC 4648 has them") {
    CHECK(data_address("text/plain", "") == "data:text/plain;base64,");
    CHECK(data_address("text/plain", "f") == "data:text/plain;base64,Zg==");
    CHECK(data_address("text/plain", "fo") == "data:text/plain;base64,Zm8=");
    CHECK(data_address("text/plain", "foobar") == "data:text/plain;base64,Zm9vYmFy");
    CHECK(data_address("a/b", "\xff\xfe\xfd") == "data:a/b;base64,//79");
}

TEST_CASE("the class report lists stages, left-over files, and forbidden operations") {
    ClassOfTwo two;
    write_text(two.folder / left_over_file, "list.txt: <nobody's>\n");
    two.marks[0].cases[1].words = "Your code tried a forbidden operation: files\n";
    for (CaseMark& each : two.marks[3].cases)
        each.words = "CHECK( hits )\n  got:      Your code crashed: Aborted.\n";
    write_class_report(two.folder, RAYSTEPS_ROOT, two.marks, {}, "2026-11-22, seed 12");
    const std::string page = read_text(two.folder / "class.html");
    CHECK(well_formed(page));
    CHECK(has(page, "<th class=\"stage\"><span>4 plane</span></th>"));
    CHECK(has(page, "<p class=\"soft\">2026-11-22, seed 12</p>"));
    CHECK(has(page, "<td class=\"text\">list.txt: &lt;nobody&#39;s&gt;</td>"));
    CHECK(has(page,
              "Forbidden operations: files, processes, networks</h3>\n<div "
              "class=\"scroll\"><table class=\"list\">\n<tr><td class=\"text\">=cmd|&quot;&lt;b&gt;"
              "&amp;\n</td><td class=\"text\">4 plane</td><td class=\"text\">in 1 case</td></tr>"));
    CHECK(has(page, "<td class=\"text\">5 triangle</td><td class=\"text\">no &lt;vec&gt;</td>"));
    CHECK(has(page,
              "Crashes, and limits of time</h3>\n<div class=\"scroll\"><table class=\"list\">\n"
              "<tr><td class=\"text\">zoe</td><td class=\"text\">5 triangle</td><td "
              "class=\"text\">in 2 cases</td><td class=\"text\">Your code crashed: Aborted.</td>"
              "</tr>"));
}

TEST_CASE("a stage that the grader could not judge is named in every report, and is no mark") {
    ClassOfTwo results;
    results.marks[0].verdict = Verdict::postponed;
    results.marks[0].words = "It will be judged again.\n";
    results.marks[0].cases.clear();
    const Mark& postponed = results.marks[0];
    write_mark(results.folder, postponed);
    const std::string name = name_of(postponed.stage);
    CHECK(missing_marks(results.folder, results.marks) ==
          std::vector<std::string>{postponed.student + " has no mark for " + name});
    write_grade_book(results.folder, results.marks, {});
    CHECK(has(read_text(results.folder / "grades.csv"),
              stage_title(postponed.stage) + ": not graded yet"));
    write_feedback(results.folder, results.marks, {});
    const std::string page =
        read_text(student_folder(results.folder, postponed.student) / "feedback.html");
    CHECK(has(page, "not graded yet"));
    CHECK(has(page, "<p>It will be judged again.\n</p>"));
    write_class_report(results.folder, RAYSTEPS_ROOT, results.marks, {});
    CHECK(has(read_text(results.folder / "class.html"), "Not judged yet"));
}

TEST_CASE("the class report lists cases that were not reached, and changed copies of main.cpp") {
    ClassOfTwo results;
    results.marks[0].cases.push_back({.name = "late", .words = std::string(not_reached) + "\n"});
    results.marks[0].words = std::string(copied_main) + "\n";
    write_class_report(results.folder, RAYSTEPS_ROOT, results.marks, {});
    const std::string page = read_text(results.folder / "class.html");
    CHECK(has(page, not_reached));
    CHECK(has(page, "Copies of the project's main.cpp"));
    CHECK(well_formed(page));
}

TEST_CASE("a class without marks makes empty reports") {
    const Results results;
    write_grade_book(results.folder, {});
    write_junit(results.folder, {});
    write_feedback(results.folder, {});
    write_class_report(results.folder, RAYSTEPS_ROOT, {});
    CHECK(read_text(results.folder / "grades.csv") == "student,total,of\r\n");
    CHECK(well_formed(read_text(results.folder / "junit.xml")));
    CHECK(well_formed(read_text(results.folder / "class.html")));
}

}  // namespace rt::grade
