#!/bin/sh
# A student's way through stage 3, from the starter on: course_test.sh PROJECT_FOLDER
#
# It runs in a copy of the project, since the student's files are among the sources; the needed
# parts are built there again, so that this is a part of .ci/run, and not of `./course test`.
project=$1
. "$(dirname "$0")/../lib.sh"
copy_project "$project"
cd "$folder" || exit 1
stage=steps/step03_sphere
mine=$stage/student/sphere.cpp
trace=$stage/student/main.cpp

# answer SUITE NAME FILE: the file becomes a known mistake, or another right answer.
answer() {
    cmake --build build --target known_mistakes > log 2>&1 || fail "known_mistakes is built"
    build/known_mistakes . "$1" "$2" > "$3"
}

# Answers without a build.
course 2 check 3
says "nothing is started yet: ./course start 3"
[ ! -e build ] || fail "nothing is built to say that nothing is started"
touch build
course 2
says "build cannot be written: copy the project to a folder of yours"
rm build

# On a terminal, the first build shows what it does and how far it is.
if has_terminal; then
    script -qec ./course /dev/null < /dev/null > out
    grep -q -e '-- Detecting CXX' out || fail "configuring is shown"
    grep -q '\[[1-9][0-9]*/[1-9][0-9]*\] ./course: Building CXX object' out || fail "building is shown"
fi
course 0
[ "$(grep -c '[0-9]  step[0-9][0-9]_' out)" = "$(ls -d steps/step*/ | wc -l)" ] || fail "a line for each stage"
says "Next: ./course start 1"

course 2 check 3
says "./course start 3"
course 0 start 3
cmp -s $stage/starter/sphere.cpp $mine || fail "the starter is there"
cmp -s $stage/starter/main.cpp $trace || fail "the starter's trace is there"
course 2 start sphere
says "./course reset 3"
course 1 check
says "Not written yet: intersect, normal, color_from_normal, torch, trace."
says "✗ the unit sphere five ahead"
says "Write next: intersect, in $mine:"
says "Stuck? ./course hint 3"
[ "$(grep -c '✗' out)" = 1 ] || fail "one failing case"
course 1 check 3 --all
says "  ✗ 1 intersect: "
says "      ✗ the unit sphere five ahead"
says "      ✗ a sphere that is alone"
says "  · passes unwritten too"
course 0 run 3 -o picture.png --size 40x30
says "$trace:"
says "trace is not written yet"
says_not "all pixels have one color"
rm picture.png
course 0 hint 3
says "step03_sphere, intersect, hint 1 of 3"
says_not "torch"
course 0
says "▸  3  step03_sphere"

# The functions are right; trace is not written yet, then wrong, then right. The next stage goes on
# from it, under its own first comment. A student who writes the functions only removes the file.
cp $stage/reference/sphere.cpp $mine
course 1 check 3
says "✗ a sphere that is alone is seen in its color (M1)"
says "Write next: trace, in $trace:"
says_not "✗ the normal points away"
course 0 hint 3
says "step03_sphere, trace, hint 1 of 3"
answer step03_sphere_trace last_hit $trace
course 1 check 3
says "✗ the closest of several spheres is seen"
says "sp 0,0,-20 2 0,0,255"
says_not "✗ a sphere that is alone"
answer step03_sphere_trace dithered $trace
course 1 check 3
says "state keeps its value from one ray to the next: your color may depend"
answer step03_sphere_trace sorted sorted.cpp
cp sorted.cpp $trace
course 0
says "changed since "
course 0 check 3
says "the same picture as the reference's"
says "Next: ./course start 4"
# What every case passes and threads do not: pixels of other threads are red.
if [ "$(nproc)" -gt 1 ]; then
    sed -e '1a #include <thread>' -e '/^Color trace(/a \
        using namespace std::chrono_literals; \
        static const std::thread::id first = std::this_thread::get_id(); \
        if (context.pixel.row == 1 && context.pixel.column == 0) std::this_thread::sleep_for(50ms); \
        if (std::this_thread::get_id() != first) return {1, 0, 0};' \
        sorted.cpp > $trace
    course 1 check 3
    says "Drawn again with one thread, your picture is another one."
    says "not the picture"
    says_not "Next: "
    cp sorted.cpp $trace
fi
course 0 start 4
next=steps/step04_plane/student/main.cpp
[ "$(head -n 1 $next)" = "$(head -n 1 steps/step04_plane/starter/main.cpp)" ] || fail "its comment"
grep -q min_element $next || fail "the student's trace goes on"
# A main.cpp alone: the reference's functions are judged, and the grader has none.
mv $mine moved
course 0 check 3
says "student/sphere.cpp: warning: it is missing, so that the reference's functions were judged"
says "Next: ./course check 4"
mv moved $mine
rm -r steps/step04_plane/student $trace

# Right, and then changed.
course 0 check 3
says "the same picture as the reference's"
says "Next: ./course start 4"
says_not "✗"
says_not "warning: "
course 0
says "✓  3  step03_sphere"
grep -q '^passed: ' $stage/student/progress.txt || fail "what is remembered can be read"
echo >> $mine
course 0
says "changed since it passed"

# A ray tracer of the student's own; own_test.sh tests the rest.
course 0 own tracer
says "left out, as not started: step01_ray_generation"
course 2 own tracer
says "tracer: error: exists already"
course 2 own --check tracer
says "tracer/build/tracer: error: no such program"
course 2 own --check ""
says 'own: expected a name, not ""'

# A forbidden include in a graded file: it passes here, with a warning. An allowed one: the headers
# of its own header. A comment includes nothing. A second source file: linked here, with a warning.
echo "// of mine" > $stage/student/helpers.hpp
echo "// of mine" > $stage/student/helpers.cpp
{
    printf '#include "%s"\n' common/./geometry/ray.hpp common/scene/scene.hpp helpers.hpp ../sphere.hpp
    printf '# include <steps/step04_plane/plane.hpp>\n'
    printf '/* not so:\n#include "common/image/png.hpp"\n*/ // #include "common/render/render.hpp"\n'
    cat $stage/reference/sphere.cpp
} > $mine
course 0 check 3
says "$mine:2: warning: a graded file may not include common/scene/scene.hpp: docs/step03_sphere.md lists the allowed headers"
says "$mine:3: warning: a graded file may not include helpers.hpp: "
says "$mine:4: warning: a graded file may not include ../sphere.hpp: "
says "$mine:5: warning: a graded file may not include steps/step04_plane/plane.hpp: "
says "$stage/student/helpers.cpp: warning: only sphere.cpp is graded: "
[ "$(grep -c 'warning: ' out)" = 5 ] || fail "five warnings"
rm $stage/student/helpers.hpp $stage/student/helpers.cpp
cp $stage/reference/sphere.cpp $mine
echo >> $mine

# A syntax error: the compiler's message at the student's own line, and nothing else.
printf 'int broken(\n' >> $mine
lines=$(wc -l < $mine)
course 1 check 3
head -n 1 out | grep -q "^$mine:$lines:.*: error: " || fail "the first error is at line $lines"
[ "$(wc -l < out)" -le 4 ] || fail "nothing else"
course 2 run 4 -o picture.png
says "$mine:"
says "--reference 3"
[ ! -e picture.png ] || fail "no picture"
course 0 run 4 --reference 3 -o picture.png
[ -s picture.png ] || fail "a picture without that stage"

# A missing and a duplicate symbol: the linker's message, made readable.
sed 's/^Vec3 normal(/Vec3 normal_of(/' $stage/reference/sphere.cpp > $mine
course 1 check 3
says "nothing defines rt::normal("
sed 's/^}  \/\/ namespace rt$/float drawn_twice() { return 1; }\n&/' $stage/reference/sphere.cpp > $mine
course 1 check 3
says "anonymous namespace"

# A helper outside an anonymous namespace: a warning each time, though it is compiled once, and one
# more if another stage has the same. That stage is judged with this stage's reference, and a line reports it.
sed 's/^}  \/\/ namespace rt$/Real twice(Real x) { return 2 * x; }\n&/' $stage/reference/sphere.cpp > $mine
course 0 run 3 -o picture.png
./course run 3 --pixel 240,320 2> out | true
says_not "crashed"
if command -v flock > /dev/null; then  # two builds at a time would spoil ninja's logs
    flock build/building sh -c 'sleep 3; touch released' &
    sleep 1
    course 0 run 3 -o picture.png
    [ -e released ] || fail "a build waits for another one"
    wait
fi
for _ in first second; do
    course 0 check 3
    says "$mine:"
    says "warning: no previous "  # declaration, or clang++: prototype
    says "anonymous namespace"
    says_not "is defined twice"
done
other=steps/step04_plane
course 0 start 4
sed 's/^}  \/\/ namespace rt$/Real twice(Real x) { return 2 * x; }\n&/' $other/reference/plane.cpp \
    > $other/student/plane.cpp
rm $other/student/main.cpp
course 0 check 4
says "$other/student/plane.cpp: warning: rt::twice(double) is defined twice, also in $mine"
says "Judged with the references in place of your stage 3; ./course run 4 uses yours."
course 2 run 4 -o picture.png
says "error: defined twice: rt::twice("
says "$mine"
cp $other/reference/plane.cpp $other/student/plane.cpp
answer step03_sphere subtracts_r_squared $mine
course 0 run 4 -o picture.png
says "your step03_sphere is used: changed since it passed."
course 0 run 4 --reference 3 -o picture.png
says_not "step03_sphere is used"
course 0 compare 4
says "Judged with the references in place of your stage 3"
course 1 compare 4 --mine scenes/step04_plane.rt --size 64x48
says "Why? ./course explain 4 --mine scenes/step04_plane.rt --size 64x48"
cp scenes/step04_plane.rt "my scene.rt"
course 1 compare 4 --reference 4,1 "my scene.rt"
says "Why? ./course explain 4 --reference 4,1 'my scene.rt'"
rm -r $other/student "my scene.rt" picture.png

# A wrong answer: the case, the call, the line to paste, and the pixels.
answer step03_sphere near_root_only $mine
course 1 check 3
says "You try the smaller root only."
says_not "near_root_only"
says "✗ a ray from inside hits the far side"
says_not "paste: "
says_not "✓"
says "Look at intersect. Stuck? ./course hint 3"
[ "$(wc -l < out)" -lt 24 ] || fail "one screen"
course 1 check 3 --all
says "mistake: near_root_only"
says "paste:    CHECK(hits("
says "asked:    tests/suites/step03_sphere_test.cpp:"
! sed -n '/paste: /,/asked: /p' out | LC_ALL=C.UTF-8 grep -E '^.{121}' || fail "what to paste fits in 120 columns"
in_french 1 check 3
says "Seule la plus petite racine est testée."
# The sphere around the eye.
course 0 explain 3
says "mine          → missed according to intersect"
says "reference     → hit at t = 23.7517"
# The picture is right: the suite's failing call is explained.
answer step03_sphere absolute_epsilon $mine
course 1 check 3
course 0 explain 3
says "The picture cannot show it. The first failing case of the last check: very small spheres"
answer step03_sphere subtracts_r_squared $mine
in_french 1 check 3
says "intersect renvoie std::nullopt pour tous les appels essayés."
grep -q "^votre réponse : pas d'intersection" renders/step03_sphere_slice.svg || fail "the drawing is French"
course 1 check 3
says "intersect returns std::nullopt for every call that was tried."
says_not "Your discriminant subtracts"
course 1 compare 3
says "pixels differ"
[ -s renders/step03_sphere_compare.png ] || fail "both pictures and their difference"
course 0 compare 3 --help
says "./course run 3 --help lists them"
course 0 run 3 --help
says "Usage: step03_sphere"
! LC_ALL=C.UTF-8 grep -E '^.{81}' out || fail "no line of the help is wider"
course 2 compare 3 --requirements
says "error: with these options no picture is made: nothing is compared"
course 2 compare 3 -o picture.png
says "error: compare writes renders/step03_sphere_compare.png, and has no -o"
course 0 explain 3 --help
says "./course run 3 --help lists them"
course 0 explain 3
says "mine "
says "The first difference: "
course 0 explain 3 0,0
course 2 explain 3 9999,0
says "outside the picture"

# The same in French, and from the starter to a passed check.
in_french 0 explain 3
says "La première différence"
mv $stage/student away
french_session 3 $stage/reference/sphere.cpp sorted.cpp
rm -r $stage/student
mv away $stage/student
touch $stage/student/*  # newer than what is built

# A debugger's program, which stops in the call that fails.
course 1 check 3
course 0 debug 3 --prepare
says "The debugger stops in your function"
grep -q '^RAYSTEPS_STOP_AT=[1-9]' build/debug_case.env || fail "the call that fails is known"
course 0 debug 3 --prepare "MRT §3, the smallest positive root"  # Catch2 takes a comma for an end
grep -q '^RAYSTEPS_STOP_AT=[1-9]' build/debug_case.env || fail "the call that fails in a case with a comma"
course 2 debug 3 "no such case"
says 'no case of the last check is called "no such case"'

# What the compiler knows: a missing return, and a variable that outlives a call.
sed '/interval.contains(far)/{n;d;}' $stage/reference/sphere.cpp > $mine
course 1 check 3
says "return-type]"
sed 's/^    const Vec3 from_center/    static int calls = 0;\n    ++calls;\n&/' $stage/reference/sphere.cpp > $mine
course 0 check 3
says ": warning: calls keeps its value from one ray to the next"

# Double's results are printed before anything is compiled in float. A case that fails in float only.
sed '$s/^/static_assert(sizeof(Real) == 8);\n/' $stage/reference/sphere.cpp > $mine
course 1 check 3
says "cases pass, in double"
says "$mine:"
says "error: static assertion failed"
says_not "in float"
in_intersect='s/^std::optional<Real> intersect(.*/&\n    if (sizeof(Real) == 4 \&\& ray.origin.z == 5)'
sed "$in_intersect return std::nullopt;/" $stage/reference/sphere.cpp > $mine
course 1 check 3
says "✗ the unit sphere five ahead is hit at t = 4 (MRT §3)  (in float only)"
says "      got:      no hit"
says "Look at intersect."
sed "$in_intersect __builtin_trap();/" $stage/reference/sphere.cpp > $mine
course 1 check 3
says "your code crashed: "
says "The line: ./course debug 3."
[ "$(grep -c '✗' out)" = 1 ] || fail "cases that were not run are not listed"

# The output cannot be written; a foreign file has the picture's name.
./course > /dev/full 2> out
[ $? = 2 ] || fail "a full disk is told by the status"
says "the standard output cannot be written"
cp README.md renders/step03_sphere_compare.png
course 2 compare 3
cmp -s README.md renders/step03_sphere_compare.png || fail "what is no picture stays"
rm renders/step03_sphere_compare.png

# The student's own output has a heading.
sed 's/^Vec3 normal(.*/&\n    std::puts("I am here");/; s/^#include "steps.*/&\n#include <cstdio>/' \
    $stage/reference/sphere.cpp > $mine
course 0 check 3
says "Your code prints:"
says "  I am here"

# A suite that something else ends is no verdict.
mv build/step03_sphere_test_double kept
printf '#!/bin/sh\nkill -TERM $$\n' > build/step03_sphere_test_double
chmod +x build/step03_sphere_test_double
course 2 check 3
says "step03_sphere_test_double was told to stop before its end"
says_not "your code crashed"
mv kept build/step03_sphere_test_double
touch build/step03_sphere_test_double

# A file that is saved while it is compiled is compiled again. The compile waits for the pipe, and
# that of the other precision, too.
mkfifo $stage/student/pipe
{ cat $stage/reference/sphere.cpp; echo '#include "pipe"'; } > $mine
./course run 3 -o picture.png > /dev/null 2>&1 &
run=$!
exec 9> $stage/student/pipe  # goes on when a compiler reads it
echo '#error saved too early' > $mine
while sleep 0.1; do : > $stage/student/pipe; done 9>&- &
writer=$!
exec 9>&-
wait $run
kill $writer
course 2 run 3 -o picture.png
says "saved too early"
rm $stage/student/pipe

# A crash, an endless loop.
printf '#include "%s/sphere.hpp"\n#include <csignal>\nnamespace rt {\n%s\n%s\n%s\n%s\n}\n' $stage \
    'std::optional<Real> intersect(const Ray&, const Sphere&, Interval) { std::raise(SIGSEGV); return {}; }' \
    'Vec3 normal(const Sphere&, Vec3 point) { return point; }' \
    'Color color_from_normal(Vec3 normal) { return normal; }' \
    'Real torch(Vec3, Vec3, Vec3) { return 1; }' > $mine
course 1 check 3
says "your code crashed: Segmentation fault"
says ": 0 of 20 cases pass, in double"
says "The 19 cases after this one were not run."
sed -i 's/std::raise(SIGSEGV);/for (volatile bool on = true; on;) continue;/' $mine
course 1 check 3
says "your code does not end"
began=$(date +%s)
course 2 compare 3
says "your code does not end: it was stopped after 10 s"
[ $(($(date +%s) - began)) -lt 60 ] || fail "compare stops it as soon as check does"

# A figure of the book calls the student's file; other programs take the place of mkdocs and of the
# engine's compiler. The question is stage 3's first function: a ray from the origin along -z, a
# sphere of radius 1 around (0, 0, -5), and t from 0 on. The answer is 4.
if command -v curl > /dev/null; then
    mkdir fakes
    printf '#!/bin/sh\nexit 1\n' > fakes/clang++-14
    printf '#!/bin/sh\nfor site; do :; done\nmkdir -p "$site"\necho a page > "$site/index.html"\n' > fakes/mkdocs
    chmod +x fakes/*
    PATH=$PWD/fakes:$PATH build/course book > address 2> err &
    server=$!
    until_true 300 grep http address
    own=$(sed 's,build/book/index.html.*,own_,;q' address)
    none=0000000000000000 one=000000000000f03f
    question=0300$none$none$none$none${none}000000000000f0bf$none${none}00000000000014c0$one${none}000000000000f07f
    # answered STATUS TEXT: the figure gets it.
    answered() {
        [ "$(curl -s -m 100 -o out -w '%{http_code}' "${own}answer?stage=3&precision=0&question=$question")" = "$1" ] &&
            says "$2" || fail "a figure gets $1, $2"
    }
    cp $mine loops.cpp
    answered 422 "your code gave no answer within"
    curl -s "${own}files" > before
    sed -i 's/for (volatile bool on = true; on;) continue;/std::raise(SIGSEGV);/' $mine
    ! curl -s "${own}files" | cmp -s before || fail "a figure learns that the file is saved"
    answered 422 "your code crashed: "
    cp $stage/reference/sphere.cpp $mine
    answered 200 ""
    [ "$(od -An -tx1 out | tr -d ' \n')" = 010000000000001040 ] || fail "a figure gets 4"
    printf 'int broken(\n' >> $mine
    answered 422 "$mine:"
    mv $stage/student away
    answered 422 "./course start 3"
    mv away $stage/student
    [ "$(curl -s -o out -w '%{http_code}' "${own}answer?stage=3&precision=0&question=05")" = 400 ] || fail "no question"
    kill -INT $server
    wait $server
    mv loops.cpp $mine
    rm -r fakes address before err
fi

# Typos.
course 2 chek 3
says "no command \"chek\""
says "Did you mean check?"
course 2 check Tringle
says "Did you mean triangle?"

# The student's loop over the pixels draws stage 1, on one thread.
mkdir steps/step01_ray_generation/student
answer step01_ray_generation_trace upside_down steps/step01_ray_generation/student/main.cpp
course 0 run 1 --size 3x2 -o mine.png
course 0 run 1 --size 3x2 -o ours.png --threads 2
! cmp -s mine.png ours.png || fail "run 1 draws with the student's loop"
answer step01_ray_generation_trace size_exchanged steps/step01_ray_generation/student/main.cpp
course 2 run 1 --size 3x2 -o mine.png
says "error: "
rm -r steps/step01_ray_generation/student

# Hints, the solution.
course 0 hint 3
says "hint 1 of 3"
course 0 hint 3
course 0 hint 3
course 0 hint 3
says "hint 3 of 3"
course 0 hint 3 1
says "hint 1 of 3"
course 0 hint 3
says "hint 3 of 3"
course 2 hint 3 4
course 1 solution 3
course 0 solution 3
says "std::optional<Real> intersect("

# Saved, checked.
cp $stage/reference/sphere.cpp $mine
./course watch 3 > watched 2>&1 &
watcher=$!
until_true 300 grep "cases pass, in float and double" watched
printf 'int broken(\n' >> $mine
until_true 300 grep "^$mine:.*: error: " watched
kill $watcher
cp watched out
says "cases pass, in float and double"
says "error: "

# On a terminal: a screen of its own for each check, and keys, up to the next stage.
if has_terminal; then
    cp $stage/reference/sphere.cpp $mine
    mkfifo keys
    script -qefc "stty columns 80 rows 24 && ./course watch 3" shown < keys > /dev/null 2>&1 &
    watcher=$!
    exec 9> keys
    # pressed KEY TEXT: once the screen is there, the key leads to the text.
    pressed() {
        printf '%s' "$1" >&9
        until_true 300 grep -q "$2" shown || fail "$1 leads to $2"
    }
    until_true 300 grep -q "Next: ./course start 4" shown || fail "the first check"
    pressed h "hint 1 of 3"
    pressed l "step13_meshes"
    pressed n "Write next: intersect, in steps/step04_plane/student/plane.cpp"
    pressed q "4: r check again, h hint, n next stage, l stages, q quit"
    wait $watcher
    exec 9>&-
    [ "$(grep -c "$(printf '\033')\[2J" shown)" = 4 ] || fail "four screens"
    rm -r steps/step04_plane/student keys shown
fi

# Nothing is lost: not by a new start, not by a full disk. Files beside it are the student's too.
cp $mine kept
mkdir $stage/student_new
echo "mine" > $stage/student_new/notes.txt
course 0 reset 3
[ -s $stage/student_new/notes.txt ] || fail "a folder beside it stays"
[ -z "$(find $stage -name 'raysteps.*' -o -name '.raysteps-*')" ] || fail "nothing is left over"
says "$stage/student_1"
cmp -s kept $stage/student_1/sphere.cpp || fail "what was there is kept"
cmp -s $stage/starter/sphere.cpp $mine || fail "the starter is back"
echo "mine" >> $mine
cp $mine kept
(
    trap '' XFSZ
    ulimit -f 0
    build/course reset 3 2>&1
) | cat > out
says "error: "
cmp -s kept $mine || fail "a full disk leaves what was there"
[ ! -e $stage/student_2 ] || fail "and nothing else"
exit $failed
