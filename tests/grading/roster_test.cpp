// The lists of a class: exports of platforms in several languages, and spreadsheets.
#include "common/course/grade/reports/reports.hpp"
#include "common/system/files.hpp"

#include "tests/grading/reports_class.hpp"
#include "tests/kit/catch.hpp"

namespace rt::grade {

namespace fs = std::filesystem;

namespace {

/// Moodle's names: Zoé has 7 of 14 points, and Bob 14. Numéro 125 has submitted nothing.
struct Moodle : TermClass {
    Moodle() {
        add("Zoé_Doe_123", 3, 7, 14);
        add("Bob_Ray_124", 3, 14, 14);
        for (const Mark& mark : marks) write_mark(folder, mark);
    }
};

constexpr const char* french_head =
    "Identifiant,\"Nom complet\",\"Adresse de courriel\",Statut,Groupe,Note,\"Note "
    "maximale\",\"La note peut être modifiée\",\"Dernière modification (travail "
    "remis)\",\"Dernière modification (note)\",\"Feedback par commentaires\"\n";

}  // namespace

TEST_CASE("Moodle's grading worksheet is returned with grades, relative to its maximum") {
    const Small two;
    const std::string head =
        "Identifier,\"Full name\",\"Email address\",Status,Grade,\"Maximum Grade\",\"Grade can be "
        "changed\",\"Last modified (grade)\",\"Feedback comments\"\n";
    two.write("sheet.csv", "\xef\xbb\xbf" + head +
                               "\"Participant 2\",\"Ben, B\",b@x,Submitted,,100.00,Yes,-,\n"
                               "\"Participant 1\",-Ann,a@x,Submitted,,100.00,Yes,-,\n"
                               "\"Participant 9\",Zoe Doe,z@x,No submission,,100.00,Yes,-,\n");
    two.write("term.txt", "roster: sheet.csv\n");
    // 4 and 8 of 14
    CHECK(two.upload() ==
          "\xef\xbb\xbf"
          "Identifier,Full name,Email address,Status,Grade,Maximum Grade,Grade can be changed,"
          "Last modified (grade),Feedback comments\r\n"
          "Participant 2,\"Ben, B\",b@x,Submitted,28.57,100.00,Yes,-,\r\n"
          "Participant 1,-Ann,a@x,Submitted,57.14,100.00,Yes,-,\r\n"
          "Participant 9,Zoe Doe,z@x,No submission,0,100.00,Yes,-,submitted nothing\r\n");
    CHECK(two.term().notes.empty());
    two.write("term.txt", "roster: sheet.csv\nbonus: 5\n");
    CHECK(has(two.upload(), "-Ann,a@x,Submitted,100,100.00"));
    two.write("term.txt", "roster: sheet.csv\n");
    CHECK(has(two.book(), "zoe_doe_9,0,0,0,14,submitted nothing"));
}

TEST_CASE("Canvas's gradebook is returned with one column, and the points possible") {
    const Small two;
    two.write("gradebook.csv",
              "Student,ID,SIS User ID,SIS Login ID,Section,Essay (77),Final Score\n"
              "    Points Possible,,,,,10,(read only)\n"
              "\"Ann, A\",1,u1,l1,S,9,90\n"
              "\"Ben, B\",2,u2,l2,S,8,80\n"
              "\"Student, Test\",99,,t,S,,\n");
    two.write("term.txt", "roster: gradebook.csv\nout of: 28\n");
    CHECK(two.upload() ==
          "Student,ID,SIS User ID,SIS Login ID,Section,Raysteps\r\n"
          "    Points Possible,,,,,28\r\n"
          "\"Ann, A\",1,u1,l1,S,16\r\n"
          "\"Ben, B\",2,u2,l2,S,8\r\n"
          "\"Student, Test\",99,,t,S,\r\n");
    two.write("term.txt", "roster: gradebook.csv\ngrade: Essay (77)\n");
    // 8 of 14 points are 5.71 of the 10 possible.
    CHECK(has(two.upload(), "    Points Possible,,,,,10\r\n\"Ann, A\",1,u1,l1,S,5.71\r\n"));
    two.write("term.txt", "roster: gradebook.csv\ngrade: Essay (77)\nout of: 28\n");
    CHECK(has(two.error(), "term.txt:3: error: the roster has its own maximum, 10"));
}

TEST_CASE("Moodle's worksheet is known in French, with its maximum and its decimal comma") {
    const Moodle moodle;
    moodle.write(
        "notes.csv",
        std::string("\xef\xbb\xbf") + french_head +
            "Participant124,\"Bob Ray\",b@x.fr,\"Remis pour évaluation\",,,\"20,00\",Oui,-,-,\n"
            "Participant123,\"Zoé Doe\",z@x.fr,\"Remis pour évaluation\",,,\"20,00\",Oui,-,-,\n"
            "Participant125,\"Léa Roy\",l@x.fr,\"Pas de remise\",,,\"20,00\",Oui,-,-,\n");
    moodle.write("term.txt", "roster: notes.csv\n");
    CHECK(moodle.term().notes.empty());
    std::string all = moodle.upload();
    CHECK(
        has(all, "Participant124,Bob Ray,b@x.fr,Remis pour évaluation,,20,\"20,00\",Oui,-,-,\r\n"));
    CHECK(
        has(all, "Participant123,Zoé Doe,z@x.fr,Remis pour évaluation,,10,\"20,00\",Oui,-,-,\r\n"));
    CHECK(has(all,
              "Participant125,Léa Roy,l@x.fr,Pas de remise,,0,\"20,00\",Oui,-,-,submitted "
              "nothing\r\n"));
    CHECK(all.starts_with("\xef\xbb\xbfIdentifiant,Nom complet,"));
    CHECK(write_upload(moodle.folder, moodle.marks, moodle.term()) ==
          "upload.csv: 3 of 3 lines have a grade, in column \"Note\", of 20");
    // By hand and with a blank, as other versions write it; a third of the points.
    moodle.write("by_hand.csv", "student,stage,points\nParticipant 123,total,\"4,67\"\n");
    moodle.write("notes.csv",
                 "Identifiant;Nom complet;Note;Note maximale;Feedback par commentaires\n"
                 "Participant 123;Zoé Doe;;20,00;\nParticipant 124;Bob Ray;;20,00;\n");
    moodle.write("term.txt",
                 "roster: notes.csv\nstudent: Identifiant\ngrade: Note\ncomment: Feedback par "
                 "commentaires\noverrides: by_hand.csv\n");
    all = moodle.upload();
    CHECK(has(all, "Participant 123;Zoé Doe;6,67;20,00;in all: 4.67 instead of 7\r\n"));
    CHECK(has(all, "Participant 124;Bob Ray;20;20,00;\r\n"));
}

TEST_CASE("Moodle's worksheet is known in German and Spanish, and by its settings in Italian") {
    const Moodle moodle;
    const auto grades = [&](const std::string& sheet, const std::string& settings = "") {
        moodle.write("sheet.csv", sheet);
        moodle.write("term.txt", "roster: sheet.csv\n" + settings);
        return moodle.upload();
    };
    CHECK(has(grades("ID,\"Vollständiger Name\",Status,Bewertung,Bestwertung,\"Feedback als "
                     "Kommentar\"\nTeilnehmer/in123,\"Zoé Doe\",Abgegeben,,\"24,00\",\n"),
              "Teilnehmer/in123,Zoé Doe,Abgegeben,12,\"24,00\","));
    CHECK(has(grades("Identificador,\"Nombre completo\",Calificación,\"Calificación "
                     "máxima\",\"Comentarios de retroalimentación\"\nParticipante123,\"Zoé "
                     "Doe\",,\"10,00\",\n"),
              "Participante123,Zoé Doe,5,\"10,00\","));
    CHECK(has(grades("Identificativo,\"Nome completo\",Voto,\"Voto massimo\"\n"
                     "Partecipante123,\"Zoé Doe\",,\"30,00\"\n",
                     "student: identificativo\nname: Nome completo\ngrade: Voto\nmaximum: Voto "
                     "massimo\n"),
              "Partecipante123,Zoé Doe,15,\"30,00\""));
}

TEST_CASE("a student is found by the full name, or by the first and the last name") {
    const Moodle moodle;
    moodle.write("term.txt", "roster: a.csv\nstudent: Nom complet\n");
    moodle.write("a.csv", "Nom complet,Note\nZOÉ DOE,\nBob Ray,\nLéa Roy,\n");
    CHECK(moodle.upload() ==
          "Nom complet,Note,Raysteps\r\nZOÉ DOE,,7\r\nBob Ray,,14\r\nLéa Roy,,0\r\n");
    // Gradescope's and most universities' lists have two columns, and numbers of their own.
    moodle.write("a.csv",
                 "First Name,Last Name,SID,Email,Total Score,Max Points\n"
                 "Zoé,Doe,2140017,z@x,,10.0\nBob,Ray,2140124,b@x,,10.0\n");
    moodle.write("term.txt",
                 "roster: a.csv\nstudent: SID\nname: First Name + Last Name\ngrade: Total "
                 "Score\nmaximum: Max Points\n");
    CHECK(has(moodle.upload(), "Zoé,Doe,2140017,z@x,5,10.0\r\nBob,Ray,2140124,b@x,10,10.0\r\n"));
}

TEST_CASE("a roster that fits no submission is an error, and one bad line costs itself alone") {
    Moodle moodle;
    moodle.write("term.txt", "roster: a.csv\nstudent: Login\n");
    moodle.write("a.csv", "Login,Name\nzdoe,Z. D.\nbray,B. R.\n");
    CHECK(has(moodle.error(),
              "a.csv: error: no line of it is one of the submissions, such as "
              "Bob_Ray_124: its students are taken from column \"Login\""));
    CHECK(has(moodle.error(), "name others of \"Login\", \"Name\""));
    moodle.write("a.csv", "Login,Note\n");
    CHECK(has(moodle.error(), "a.csv: error: no line"));
    // Two have the number 123. The line stays as it is, and the others are graded.
    moodle.add("Mal_Vex_123", 3, 14, 14);
    moodle.write("a.csv",
                 "Login,Raysteps\nParticipant 123,old\nParticipant 124,\nParticipant 124,\n");
    CHECK(moodle.upload() ==
          "Login,Raysteps\r\nParticipant 123,old\r\nParticipant 124,14\r\nParticipant 124,\r\n");
    CHECK(moodle.term().notes ==
          std::vector<std::string>{
              "a.csv:2: error: \"Participant 123\" may be Mal_Vex_123, Zoé_Doe_123: write one of "
              "these names; it has no grade",
              "a.csv:4: error: \"Participant 124\" is Bob_Ray_124, who is listed already; it has "
              "no grade",
              "Mal_Vex_123: submitted, but is not on the roster",
              "Zoé_Doe_123: submitted, but is not on the roster"});
    // As the message says, while the others stay numbers.
    moodle.write("a.csv", "Login,Raysteps\nZoé_Doe_123,\nParticipant 124,\n");
    CHECK(has(moodle.upload(), "Zoé_Doe_123,7\r\nParticipant 124,14\r\n"));
    moodle.write("term.txt", "roster: a.csv\nstudent: Login\nmaximum: Max\n");
    moodle.write("a.csv", "Login,Raysteps,Max\nZoé_Doe_123,,twenty\nParticipant 124,,20\n");
    CHECK(has(moodle.upload(), "Zoé_Doe_123,7,twenty\r\nParticipant 124,20,20\r\n"));
    CHECK(has(moodle.term().notes.at(0), "a.csv:2: \"twenty\" is no maximum"));
}

TEST_CASE("a student's number is another's name for nobody, and namesakes are not exchanged") {
    TermClass moodle;
    moodle.add("Zoe_Doe_124", 3, 14, 14);  // a namesake of 123, who has submitted nothing
    moodle.add("Bob_Ray_130", 3, 14, 14);
    moodle.write("a.csv",
                 "Identifier,Full name,Grade,Maximum grade\nParticipant 123,Zoe "
                 "Doe,,14\nParticipant 124,Zoe Doe,,14\nParticipant 130,Bob Ray,,14\n");
    moodle.write("term.txt", "roster: a.csv\n");
    CHECK(has(moodle.upload(), "123,Zoe Doe,0,14\r\nParticipant 124,Zoe Doe,14,14\r\n"));
    // Without numbers nobody knows which of the two it is.
    moodle.write("a.csv", "Login,Name\nzd1,Zoe Doe\nzd2,Zoe Doe\nbr,Bob Ray\n");
    moodle.write("term.txt", "roster: a.csv\nstudent: Login\n");
    CHECK(moodle.upload() ==
          "Login,Name,Raysteps\r\nzd1,Zoe Doe,\r\nzd2,Zoe Doe,\r\nbr,Bob Ray,14\r\n");
    CHECK(has(moodle.term().notes.at(0),
              "a.csv:2: error: \"Zoe Doe\" is the name of 2 lines, one "
              "of them Zoe_Doe_124: write that in its column \"Login\""));
    moodle.write("a.csv", "Login,Name\nzd1,Zoe Doe\nZoe_Doe_124,Zoe Doe\nbr,Bob Ray\n");
    CHECK(moodle.upload() ==
          "Login,Name,Raysteps\r\nzd1,Zoe Doe,0\r\nZoe_Doe_124,Zoe Doe,14\r\nbr,Bob Ray,14\r\n");
}

TEST_CASE("a line with an empty number has its name's grade, and one with another number none") {
    const Moodle moodle;
    moodle.write("term.txt", "roster: a.csv\nstudent: Numéro\nname: Nom\ngrade: TP\n");
    moodle.write("a.csv", "Numéro;Nom;TP\n;;\n123;Zoé Doe;\n;Bob Ray;\n");
    CHECK(moodle.upload() == "Numéro;Nom;TP\r\n;;\r\n123;Zoé Doe;7\r\n;Bob Ray;14\r\n");
    moodle.write("a.csv", "Numéro;Nom;TP\n123;Zoé Doe;\n142;Bob Ray;old\n143;Léa Roy;\n");
    CHECK(moodle.upload() ==
          "Numéro;Nom;TP\r\n123;Zoé Doe;7\r\n142;Bob Ray;old\r\n143;Léa Roy;0\r\n");
    CHECK(moodle.term().notes.at(0) ==
          "a.csv:3: error: \"Bob Ray\" may be Bob_Ray_124, but \"142\" is another number; it has "
          "no grade");
}

TEST_CASE("sheets as spreadsheets write them: separators and breaks in headings, a first line") {
    const Moodle moodle;
    const auto grades = [&](const std::string& sheet, const std::string& settings) {
        moodle.write("a.csv", sheet);
        moodle.write("term.txt", "roster: a.csv\ngrade: TP\n" + settings);
        return moodle.upload();
    };
    CHECK(has(grades("\"Nom, prénom\";TP\nZoé Doe;\nBob Ray;\n", "student: Nom, prénom\n"),
              "\r\nZoé Doe;7\r\nBob Ray;14\r\n"));
    CHECK(has(grades("\"Numéro, ou code, ou login\";\"Nom, prénom\";TP\n123;\"Doe, Zoé\";\n",
                     "student: Numéro, ou code, ou login\n"),
              "\r\n123;Doe, Zoé;7\r\n"));
    CHECK(has(grades("\"Numéro\r\nétudiant\";Nom;Prénom;TP\r\n123;Doe;Zoé;\r\n",
                     "student: Numéro étudiant\nname: Prénom + Nom\n"),
              "\r\n123;Doe;Zoé;7\r\n"));
    CHECK(grades("sep=;\nNuméro;Nom;TP\n124;\"Ray, Bob, Jr., II\";\n", "student: Numéro\n") ==
          "Numéro;Nom;TP\r\n124;Ray, Bob, Jr., II;14\r\n");
    CHECK(has(grades("Numéro;Nom;TP\n123; \"Doe; Zoé\";\n124;Bob 6\" Ray;\n", "student: Numéro\n"),
              "\r\n123;\"Doe; Zoé\";7\r\n124;\"Bob 6\"\" Ray\";14\r\n"));
    for (const std::string most : {"-20", "0"}) {
        CHECK(has(grades("Numéro;TP;Max\n124;;" + most + "\n", "student: Numéro\nmaximum: Max\n"),
                  "\r\n124;14;" + most + "\r\n"));
        CHECK(has(moodle.term().notes.at(0), "\"" + most + "\" is no maximum"));
    }
}

TEST_CASE("points above the maximum are worth the same for a student who is excused") {
    const Moodle moodle;
    moodle.write("a.csv", "student\nZoé Doe\nBob Ray\n");
    moodle.write("more.csv", "student,points\nZoé Doe,7\nBob Ray,7\n");
    moodle.write("hand.csv", "student,stage,points\nZoé Doe,3,excused\n");
    moodle.write("term.txt",
                 "roster: a.csv\nout of: 19\nadditions: more.csv\nadditions of: 5\n"
                 "overrides: hand.csv\n");
    // 7 of 5, and 21 of 19: both have 2 points above the maximum.
    CHECK(moodle.upload() == "student,Raysteps\r\nZoé Doe,21\r\nBob Ray,21\r\n");
}

TEST_CASE("two namesakes on the roster who submitted nothing have a line each") {
    const Small two;
    two.write("class.csv", "student,name\nzd1a,Zoe Doe\nzd1b,Zoe Doe\nann_1,Ann\n");
    two.write("term.txt", "roster: class.csv\n");
    CHECK(has(two.book(), "zd1b,0,0,0,14,submitted nothing"));
    CHECK(has(two.book(), "zoe_doe,0,0,0,14,submitted nothing"));
}

TEST_CASE("the students of a group have the submission of the one who submitted") {
    Moodle moodle;
    moodle.add("Paire_3", 3, 10, 14);
    moodle.write("a.csv",
                 "student,Groupe,Raysteps\nZoé Doe,Paire 1,\nLéa Roy,paire 1,\nBob Ray,Paire "
                 "2,\nMax Moe,,\nTim Toe,Paire 3,\nPia Poe,Paire 4,\n");
    moodle.write("late.csv", "student,days\nLéa Roy,1\n");
    moodle.write("term.txt", "roster: a.csv\ngroup: Groupe\nlate: late.csv\nlate percent: 50\n");
    CHECK(moodle.book() ==
          "student,step03_sphere,total,of,remarks\r\n"
          "Bob_Ray_124,14,14,14,\r\n"
          "Zoé_Doe_123,7,7,14,\r\n"
          "léa_roy,7,3.5,14,\"the submission of Zoé_Doe_123, group \"\"paire 1\"\"\n1 days late: "
          "50 % of 7 points\"\r\n"
          "max_moe,0,0,14,submitted nothing\r\n"
          "pia_poe,0,0,14,submitted nothing\r\n"
          "tim_toe,10,10,14,\"the submission of Paire_3, group \"\"Paire 3\"\"\"\r\n");
    CHECK(moodle.term().notes.empty());
    for (const Mark& mark : moodle.marks) write_mark(moodle.folder, mark);
    write_feedback(moodle.folder, moodle.marks, moodle.term());
    CHECK(has(read_text(student_folder(moodle.folder, "léa_roy") / "feedback.html"),
              "<p>3.5 of 14 points</p>"));
    write_class_report(moodle.folder, RAYSTEPS_ROOT, moodle.marks, moodle.term());
    CHECK(has(read_text(moodle.folder / "class.html"), "<h1>Class report</h1> <p>6 students"));
    // The page makes nobody a student who has submitted, and is removed with the group.
    CHECK(students_in(moodle.folder).size() == 3);
    CHECK(missing_marks(moodle.folder, moodle.marks).empty());
    moodle.write("term.txt", "roster: a.csv\n");
    write_feedback(moodle.folder, moodle.marks, moodle.term());
    CHECK_FALSE(fs::exists(moodle.folder / "students/léa_roy"));
    // Both have submitted.
    moodle.write("a.csv", "student,Groupe\nZoé Doe,A\nBob Ray,A\nLéa Roy,A\nPaire_3,\n");
    moodle.write("term.txt", "roster: a.csv\ngroup: Groupe\n");
    CHECK(has(moodle.book(), "Bob_Ray_124,14,14,14,\r\nPaire_3,10,10,14,\r\n"));
    CHECK(has(moodle.book(), "léa_roy,14,14,14,"));
    CHECK(moodle.term().notes ==
          std::vector<std::string>{
              "group \"A\" has several submissions, of Bob_Ray_124, Zoé_Doe_123: each counts for "
              "its own student, and that of Bob_Ray_124 for the others"});
}

TEST_CASE("a student's words in the upload are no formula") {
    Moodle moodle;
    moodle.marks.push_back({.student = "Mal_Vex_125",
                            .stage = 3,
                            .verdict = Verdict::missing,
                            .words = "=1+cmd.zip was not opened",
                            .most = 14});
    moodle.write("a.csv", "student,Remark,Raysteps\nMal Vex,,\n");
    moodle.write("term.txt", "roster: a.csv\ncomment: Remark\n");
    CHECK(has(moodle.upload(), "Mal Vex,'=1+cmd.zip was not opened,0\r\n"));
}

}  // namespace rt::grade
