#!/bin/sh
# A term with a French Moodle, by the command line: term_test.sh BUILD PROJECT
#
# A late archive, graded alone, changes no other student's mark; changed marks are listed; a roster
# that fits nobody ends the run.
build=$(cd "$1" && pwd)
project=$(cd "$2" && pwd)
. "$(dirname "$0")/../lib.sh"
chmod 711 "$folder"  # the compiler runs as an unprivileged user
cd "$folder" || exit 1
sphere=$project/steps/step03_sphere/reference/sphere.cpp

# grade STATUS WORDS...: its output is in the file out.
grade() {
    expected=$1
    shift
    "$build/grade" --stages 3 --out results "$@" > out 2>&1
    [ $? = "$expected" ] || fail "the status of grade $*, $expected"
}
# mark STUDENT POINTS: in the grade book
mark() { grep -q "^$1,$2," results/grades.csv || fail "$1 has $2: $(cat results/grades.csv)"; }

for student in "Zoé Doe_123" "Bob Ray_124"; do
    mkdir -p "class/${student}_assignsubmission_file_"
    cp "$sphere" "class/${student}_assignsubmission_file_"
done
grade 0 class
says "class is taken as a class of 2: Bob_Ray_124, Zoé_Doe_123"
mark Bob_Ray_124 22
mark Zoé_Doe_123 22

# A student has packed files with the names of others.
mkdir late trap
cp -r class/* trap
for file in trap/*/sphere.cpp; do echo 'int broken(' > "$file"; done
(cd trap && cmake -E tar cf ../late/mallory.zip --format=zip -- *)
for place in late late/mallory.zip; do
    grade 0 "$place"
    says "mallory.zip looks like a class of 2, Bob_Ray_124, Zoé_Doe_123, which --class would grade"
    mark Bob_Ray_124 22
    mark Zoé_Doe_123 22
    grep -q '^mallory,' results/grades.csv || fail "mallory is in the grade book"
done
# The same, unpacked: a class by its look, whose marks are from another folder.
grade 2 trap
says "trap: error: looks like a class, and would replace the marks of Bob_Ray_124, Zoé_Doe_123"
mark Zoé_Doe_123 22
# Others' files, put in the folder that was graded for another student.
cp -r trap/* late
rm late/mallory.zip
grade 2 late
says "late: error: looks like a class, and would replace the marks of Bob_Ray_124, Zoé_Doe_123"
mark Zoé_Doe_123 22
[ ! -e results/changes.csv ] || fail "no mark has changed: $(cat results/changes.csv)"

# A student of the roster, again.
{
    printf '\357\273\277Identifiant,"Nom complet",Statut,Note,"Note maximale","Feedback par commentaires"\n'
    printf 'Participant123,"Zoé Doe",Remis,,"20,00",\nParticipant124,"Bob Ray",Remis,,"20,00",\n'
} > results/notes.csv
echo 'roster: notes.csv' > results/term.txt
cp "$project/steps/step03_sphere/starter/sphere.cpp" "class/Zoé Doe_123_assignsubmission_file_"
cp "$project/steps/step03_sphere/starter/sphere.cpp" "class/Bob Ray_124_assignsubmission_file_"
grade 0 class --student "Zoé Doe"
mark Bob_Ray_124 22
mark Zoé_Doe_123 0
says "Zoé_Doe_123,step03_sphere,22,0,sphere.cpp is another"
says 'upload.csv: 2 of 2 lines have a grade, in column "Note", of 20'
says "mallory: submitted, but is not on the roster"
[ "$(wc -l < results/changes.csv)" = 2 ] || fail "one change: $(cat results/changes.csv)"
# 22 of the stage's 32 points are 13.75 of 20.
grep -q '^Participant124,Bob Ray,Remis,"13,75","20,00",' results/upload.csv || fail "$(cat results/upload.csv)"

# In French: the pages, and columns as in Moodle's worksheet.
printf 'student,points\n124,2.5\n' > results/more.csv
printf 'additions: more.csv\nlang: fr\n' >> results/term.txt
grade 0 --report
says "2 of 2 lines have a grade"
grep -q '^Nom complet,step03_sphere,Note,Note maximale' results/grades.csv || fail "$(head -n 1 results/grades.csv)"
for page in results/class.html results/students/*_12?/feedback.html; do
    sed -e '/^<style>/,/^<\/style>/d' -e 's/<[^>]*>//g' -e '/: erreur : /d' "$page" > out  # without a compiler's messages
    has_english out && fail "$page is in French"
done
grep -q '24,5 sur 32 points' results/students/Bob_Ray_124/feedback.html || fail "a decimal comma for the student"
grep -q '>24,5<' results/class.html || fail "a decimal comma for the class"
sed -i '/^additions/d' results/term.txt
grep -q 'la sphère unité' results/students/Zoé_Doe_123/feedback.html || fail "the names of cases are French"
# What is printed is in the terminal's language.
RAYSTEPS_LANG=fr grade 0 --report
says "2 lignes sur 2 ont une note"
grep -q '^Nom complet' results/grades.csv || fail "the pages are in the class's language"
sed -i '/^lang/d' results/term.txt
RAYSTEPS_LANG=fr grade 0 --report
grep -q '^student,' results/grades.csv || fail "English without a line, whatever the terminal: $(head -n 1 results/grades.csv)"
echo 'lang: xx' >> results/term.txt
grade 2 --report
says 'results/term.txt:2: error: "xx" is no language: expected en, or a folder of lang/'
sed -i '/^lang/d' results/term.txt

cp results/grades.csv before
sed -i 's/Participant12/Participant90/; s/Zoé Doe/Eva Roy/; s/Bob Ray/Ben Moe/' results/notes.csv
grade 2 class
says "notes.csv: error: no line of it is one of the submissions, such as "
cmp -s before results/grades.csv || fail "a run that ends writes nothing"
exit $failed
