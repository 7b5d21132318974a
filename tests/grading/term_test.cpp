// A lecturer's settings: their effect on marks, computed by hand, and their errors.
#include "common/course/grade/reports/reports.hpp"
#include "common/system/files.hpp"

#include "tests/grading/reports_class.hpp"
#include "tests/kit/catch.hpp"

namespace rt::grade {

namespace fs = std::filesystem;

TEST_CASE("without settings a grade book is the marks") {
    const Small two;
    CHECK(two.book() ==
          "student,step03_sphere,step05_triangle,total,of\r\n"
          "ann_1,3,5,8,14\r\n"
          "ben_2,4,0,4,14\r\n");
}

TEST_CASE("stages have weights, and some are a bonus") {
    const Small two;
    two.write("term.txt", "# this term\nweight: sphere 2\nweight: 5 0.5\n");
    CHECK(two.book() ==
          "student,step03_sphere,step05_triangle,total,of\r\n"
          "ann_1,6,2.5,8.5,13\r\n"
          "ben_2,8,0,8,13\r\n");
    two.write("term.txt", "bonus: 5\n");
    CHECK(two.book() ==
          "student,step03_sphere,step05_triangle,total,of\r\n"
          "ann_1,3,5,8,4\r\n"
          "ben_2,4,0,4,4\r\n");
}

TEST_CASE("a lecturer's file is none that the reports replace") {
    const Small two;
    two.write("upload.csv", "student,Raysteps\nann_1,\nben_2,\n");
    two.write("term.txt", "roster: ./upload.csv\n");
    CHECK(has(two.error(), "term.txt:1: error: upload.csv is a report"));
}

TEST_CASE("a day late costs a share of the points, and no more than all") {
    const Small two;
    two.write("late.csv", "student,days\nAnn_1,2\nben_2,30\n");
    two.write("term.txt", "late: late.csv\nlate percent: 10\n");
    CHECK(two.book() ==
          "student,step03_sphere,step05_triangle,total,of,remarks\r\n"
          "ann_1,3,5,6.4,14,2 days late: 20 % of 8 points\r\n"
          "ben_2,4,0,0,14,30 days late: 100 % of 4 points\r\n");
}

TEST_CASE("a lecturer's points go before the grader's, with the reason, and last") {
    const Small two;
    two.write("overrides.csv",
              "\xef\xbb\xbfstudent;stage;points;comment\r\n"
              "ann_1;triangle;7,5;\"edges; by hand\"\r\n"
              "2;total;12;oral exam\r\n"
              "carl;3;1;nobody\r\n");
    two.write("term.txt", "overrides: overrides.csv\n");
    for (int again = 0; again < 2; ++again)
        CHECK(two.book() ==
              "student,step03_sphere,step05_triangle,total,of,remarks\r\n"
              "ann_1,3,7.5,10.5,14,\"5 triangle: 7.5 instead of 5: edges; by hand\"\r\n"
              "ben_2,4,0,12,14,in all: 12 instead of 4: oral exam\r\n");
    CHECK(two.term().notes ==
          std::vector<std::string>{"overrides.csv:4: there is no student \"carl\""});
    write_feedback(two.folder, two.marks, two.term());
    const std::string page = read_text(student_folder(two.folder, "ann_1") / "feedback.html");
    CHECK(has(page, "<p>10.5 of 14 points</p>"));
    CHECK(has(page, "5 triangle: 7.5 instead of 5: edges; by hand"));
    write_class_report(two.folder, RAYSTEPS_ROOT, two.marks, two.term());
    CHECK(has(read_text(two.folder / "class.html"), "carl"));
}

TEST_CASE(
    "a lecturer's points of no graded stage, and more than there are, are allowed and reported") {
    const Small two;
    two.write("overrides.csv",
              "student,stage,points\n"
              "ann_1,7,3\n"
              "ann_1,5,100\n"
              "ben_2,total,25\n"
              "ben_2,3,4\n");
    two.write("term.txt", "weight: 5 2\noverrides: overrides.csv\n");  // 4 + 2 x 10 points
    CHECK(two.book() ==
          "student,step03_sphere,step05_triangle,total,of,remarks\r\n"
          "ann_1,3,200,203,24,5 triangle: 100 instead of 5\r\n"
          "ben_2,4,0,25,24,\"3 sphere: 4 instead of 4\nin all: 25 instead of 4\"\r\n");
    CHECK(two.term().notes ==
          std::vector<std::string>{
              "overrides.csv:2: step07_cylinder is not graded: its points do not count",
              "overrides.csv:3: 100 points are more than the 10 of step05_triangle; they count",
              "overrides.csv:4: 25 points are more than the 24 of all stages; they count"});
}

TEST_CASE("a stage from which a student is excused counts neither for nor against") {
    const Small two;
    two.write("by_hand.csv", "student,stage,points,comment\nben_2,5,Excused,ill\n");
    two.write("term.txt", "overrides: by_hand.csv\n");
    CHECK(two.book() ==
          "student,step03_sphere,step05_triangle,total,of,remarks\r\n"
          "ann_1,3,5,8,14,\r\n"
          "ben_2,4,excused,4,4,5 triangle: excused: ill\r\n");
    write_feedback(two.folder, two.marks, two.term());
    CHECK(has(read_text(student_folder(two.folder, "ben_2") / "feedback.html"),
              "<p>4 of 4 points</p>"));
    write_class_report(two.folder, RAYSTEPS_ROOT, two.marks, two.term());
    CHECK(has(read_text(two.folder / "class.html"), "title=\"excused\">e</td>"));
    // 4 of 4 points are all; who is excused from everything has no grade.
    two.write("class.csv", "student,Max,Raysteps\nann_1,20,old\nben_2,20,\n");
    two.write("term.txt", "overrides: by_hand.csv\nroster: class.csv\nmaximum: Max\n");
    CHECK(two.upload() == "student,Max,Raysteps\r\nann_1,20,11.43\r\nben_2,20,20\r\n");
    two.write("by_hand.csv", "student,stage,points\nann_1,5,excused\nann_1,3,excused\n");
    CHECK(has(two.upload(), "ann_1,20,old\r\n"));
    two.write("term.txt",
              "overrides: by_hand.csv\nroster: class.csv\nmaximum: Max\nadditions of: 6\n");
    CHECK(has(two.upload(), "ann_1,20,old\r\n"));
    two.write("by_hand.csv", "student,stage,points\nann_1,total,excused\n");
    CHECK(has(two.error(), "by_hand.csv:2: error: a total cannot be excused"));
}

TEST_CASE("points in addition come after the deduction, and may be a part of the maximum") {
    const Small two;
    two.write("late.csv", "student,days\nann_1,5\n");
    two.write("style.csv",
              "student;points;comment\nann_1;1,5;style\nann_1;3;report\nben_2;-9;copied\n");
    const std::string settings = "late: late.csv\nlate percent: 10\nadditions: style.csv\n";
    two.write("term.txt", settings);
    CHECK(two.book() ==
          "student,step03_sphere,step05_triangle,total,of,remarks\r\n"
          "ann_1,3,5,8.5,14,\"5 days late: 50 % of 8 points\nin addition: 1.5: style\n"
          "in addition: 3: report\"\r\n"
          "ben_2,4,0,0,14,in addition: -9: copied\r\n");
    two.write("term.txt", settings + "additions of: 6\n");
    CHECK(has(two.book(), "ann_1,3,5,8.5,20,"));
    two.write("style.csv", "student,points\nann_1,many\n");
    CHECK(has(two.error(), "style.csv:2: error: \"many\" is no number from -1000000 to 1000000"));
}

TEST_CASE("a report that the settings do not ask for any more is removed") {
    const Small two;
    two.write("class.csv", "student\nann_1\n");
    two.write("term.txt", "roster: class.csv\nanonymous: yes\n");
    write_upload(two.folder, two.marks, two.term());
    CHECK(fs::exists(two.folder / "upload.csv"));
    CHECK(fs::exists(two.folder / "names.csv"));
    two.write("term.txt", "bonus: 5\n");
    write_upload(two.folder, two.marks, two.term());
    CHECK_FALSE(fs::exists(two.folder / "upload.csv"));
    CHECK_FALSE(fs::exists(two.folder / "names.csv"));
    CHECK(fs::exists(two.folder / "class.csv"));
}

TEST_CASE(
    "a student on the roster without a submission has a line; a submission off the roster is "
    "reported") {
    const Small two;
    two.write("class.csv", "student,email\nann_1,a@x\nZoe Doe,z@x\n");
    two.write("term.txt", "roster: class.csv\n");
    CHECK(two.book() ==
          "student,step03_sphere,step05_triangle,total,of,remarks\r\n"
          "ann_1,3,5,8,14,\r\n"
          "ben_2,4,0,4,14,\r\n"
          "zoe_doe,0,0,0,14,submitted nothing\r\n");
    CHECK(two.term().notes ==
          std::vector<std::string>{"ben_2: submitted, but is not on the roster"});
    write_upload(two.folder, two.marks, two.term());
    CHECK(read_text(two.folder / "upload.csv") ==
          "student,email,Raysteps\r\nann_1,a@x,8\r\nZoe Doe,z@x,0\r\n");
    write_class_report(two.folder, RAYSTEPS_ROOT, two.marks, two.term());
    CHECK(has(read_text(two.folder / "class.html"), "zoe_doe</th>"));
}

TEST_CASE("anonymous students have no name in public reports") {
    const Small two;
    two.write("class.csv", "student\nben_2\n");  // ann_1 is not on the roster
    two.write("term.txt", "anonymous: yes\nroster: class.csv\n");
    two.write(left_over_file, "ann_1: Canvas marks it LATE\n");
    Term term = two.term();
    term.key = 7;
    const std::string ann = term.called("ann_1");
    CHECK(ann.size() == 10);
    CHECK(ann != term.called("ben_2"));
    write_class_report(two.folder, RAYSTEPS_ROOT, two.marks, term);
    write_feedback(two.folder, two.marks, term);
    write_upload(two.folder, two.marks, term);
    CHECK_FALSE(has(read_text(two.folder / "class.html"), "ann_1"));
    CHECK(has(read_text(two.folder / "class.html"), ann));
    CHECK(has(read_text(two.folder / "class.html"), "<p>2 lines with names: left_over.txt"));
    CHECK_FALSE(has(read_text(student_folder(two.folder, "ann_1") / "feedback.html"), "ann_1"));
    CHECK(has(read_text(two.folder / "names.csv"), ann + ",ann_1\r\n"));
    term.key = 8;
    CHECK(ann != term.called("ann_1"));
}

TEST_CASE("a name that may be two students is an error, and a number names nobody else") {
    Small two;
    two.add("zoe_123", 3, 1, 4);
    two.add("zoe_124", 3, 1, 4);
    two.add("max", 3, 1, 4);
    two.add("max_2", 3, 1, 4);  // the second of two, so numbered by the grader
    two.write("class.csv", "student,name\nzoe_123,Zoe\nzoe_124,Zoe\nann_1,Ann\n");
    two.write("late.csv", "student,days\nzoe_123,1\nZoe,1\n");
    two.write("term.txt", "roster: class.csv\nlate: late.csv\n");
    CHECK(has(two.error(),
              "late.csv:3: error: \"Zoe\" may be zoe_123, zoe_124: write one of these names"));
    two.write("late.csv", "student,days\nGroup 1,3\nOther_123,3\n2,1\n");
    const Term term = two.term();
    CHECK(term.days_late == std::map<std::string, double>{{"ben_2", 1}});
    CHECK(has(term.notes.at(0), "late.csv:2: there is no student \"Group 1\""));
    CHECK(has(term.notes.at(1), "late.csv:3: there is no student \"Other_123\""));
}

TEST_CASE("a name is the same in capitals, and with its accents in letters of their own") {
    Small class_of_three;
    class_of_three.add("Zo\xc3\xa9_Dupr\xc3\xa9", 3, 1, 4);
    class_of_three.write("late.csv", "student,days\nZOE\xcc\x81 DUPR\xc3\x89,2\n");
    class_of_three.write("overrides.csv", "student,stage,points\nzoe\xcc\x81_dupre\xcc\x81,3,2\n");
    class_of_three.write("term.txt", "late: late.csv\noverrides: overrides.csv\n");
    const Term term = class_of_three.term();
    CHECK(term.notes.empty());
    CHECK(term.days_late.count("Zo\xc3\xa9_Dupr\xc3\xa9") == 1);
    CHECK(term.overrides.count({"Zo\xc3\xa9_Dupr\xc3\xa9", 3}) == 1);
    class_of_three.write("late.csv", "student,days\n\xff\xfe,2\n");  // no UTF-8
    CHECK(class_of_three.term().notes.size() == 1);
}

TEST_CASE("settings may begin with a byte order mark, and end their lines with CR") {
    const Small two;
    two.write("term.txt", "\xef\xbb\xbfweight: 5 2\rbonus: 3\r");
    CHECK(two.term().weight(5) == 2);
    CHECK(two.term().bonus.count(3) == 1);
}

TEST_CASE("an error in the settings is reported with its place") {
    const Small two;
    const auto says = [&](const std::string& settings) {
        two.write("term.txt", settings);
        return two.error();
    };
    const std::string file = (two.folder / "term.txt").string();
    CHECK(says("\nwieght: 5 2\n").starts_with(file + ":2: error: \"wieght: 5 2\" is no setting"));
    CHECK(says("weight: 5 two\n") == file + ":1: error: \"two\" is no number from 0 to 1000");
    CHECK(says("weight: ball 2\n") == file + ":1: error: no stage \"ball\"");
    CHECK(says("weight: 5\n").starts_with(file + ":1: error: a weight needs a stage"));
    CHECK(says("late percent: 101\n").starts_with(file + ":1: error: \"101\" is no number"));
    CHECK(says("roster: none.csv\n").starts_with(file + ":1: error: there is no file"));
    CHECK(says("anonymous\n") == file + ":1: error: \"anonymous\" is not \"word: value\"");
    two.write("a.csv", "who\nann_1\n");
    const std::string table = (two.folder / "a.csv").string();
    CHECK(says("roster: a.csv\n") == table + ":1: error: has no column \"student\", but \"who\"");
    two.write("a.csv", "student,days\nann_1,\"2\n");
    CHECK(says("late: a.csv\n") == table + ":2: error: this quote is not closed");
    two.write("a.csv", "student,days\n\nann_1,-2\n");
    CHECK(says("late: a.csv\n") == table + ":3: error: \"-2\" is no number from 0 to 366");
    CHECK(says("out of: 10\nout of: 20\n") == file + ":2: error: \"out of\" is set already");
    CHECK(says("weight: 5 2\nweight: triangle 3\n") ==
          file + ":2: error: stage 5 has a weight already");
    CHECK(says("roster: a.csv\ncomment: Notes\n") ==
          table + ":1: error: has no column \"Notes\", but \"student\", \"days\"");
    two.write("a.csv", "student,days\nann_1,1\nAnn 1,2\nnobody,x\n");
    CHECK(says("late: a.csv\n") == table + ":3: error: ann_1 is listed already");
    two.write("a.csv", "student,days\nnobody,x\n");
    CHECK(says("late: a.csv\n") == table + ":2: error: \"x\" is no number from 0 to 366");
    two.write("a.csv", "student,stage,points\nann_1,3,1\nann_1,sphere,2\n");
    CHECK(says("overrides: a.csv\n") ==
          table + ":3: error: ann_1 is listed already with this stage");
    two.write("a.csv", "");
    CHECK(says("roster: a.csv\n") == table + ": error: is empty");
}

TEST_CASE("a lecturer's file may be of a spreadsheet on Windows") {
    TermClass one;
    one.add("Zo\xc3\xa9_Lec\xc5\x93ur", 3, 1, 4);
    one.write("term.txt", "late: a.csv\n");
    const std::map<std::string, double> late{{"Zo\xc3\xa9_Lec\xc5\x93ur", 2}};
    one.write("a.csv", "student;days\nZo\xe9 Lec\x9cur;2\n");  // code page 1252
    CHECK(one.term().days_late == late);
    std::string utf16 = "\xff\xfe";
    for (const char c : std::string("student\tdays\r\nZo\xe9 Lec\x9cur\t2\r\n"))
        utf16 += c == '\x9c' ? std::string("\x53\x01", 2) : std::string{c, '\0'};
    one.write("a.csv", utf16);
    CHECK(one.term().days_late == late);
}

TEST_CASE("a table's lines may end with CR, as some spreadsheets write them") {
    const Small two;
    two.write("a.csv", "student;days\rann_1;\"1\"\rben_2;2\r");
    two.write("term.txt", "late: a.csv\n");
    CHECK(two.term().days_late == std::map<std::string, double>{{"ann_1", 1}, {"ben_2", 2}});
}

}  // namespace rt::grade
