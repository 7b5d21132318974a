#!/bin/sh
# The autograder for Gradescope, with stubs for the grader and for an image's tools:
# gradescope_test.sh GRADE
grade=$1
. "$(dirname "$0")/../lib.sh"
cd "$folder" || exit 1

# A relative folder, from any other.
mkdir elsewhere
(cd elsewhere && "$grade" --for gradescope ../made --stages 3,5) || fail "--for gradescope, relative"
root=$folder/autograder
mkdir -p "$root/source" "$root/submission" "$folder/bin"
(cd "$root/source" && cmake -E tar xf "$folder/made/autograder.zip") || fail "autograder.zip"
[ "$(ls made)" = autograder.zip ] || fail "nothing else is written: $(ls made)"
if [ -c /dev/full ]; then
    ! "$grade" --help > /dev/full 2> out || fail "output that is lost is an error"
fi
! TMPDIR=nowhere "$grade" --for gradescope other 2> out || fail "a wrong TMPDIR is refused"
grep -qx 'error: the variable TMPDIR must be the name of a folder' out || fail "TMPDIR: $(cat out)"
# Nothing of the lecturer's is replaced.
! "$grade" --for gradescope made 2> out || fail "a second autograder.zip is refused"
grep -q 'autograder.zip: error: exists already$' out || fail "autograder.zip exists: $(cat out)"
"$grade" --for slurm batch && "$grade" --for slurm batch || fail "the same files a second time"
echo '#SBATCH --mem=9G' >> batch/grade.sbatch
rm batch/submit.sh
! "$grade" --for slurm batch 2> out || fail "a changed grade.sbatch is refused"
grep -q 'grade.sbatch: error: exists already, with other content$' out || fail "changed: $(cat out)"
grep -q mem=9G batch/grade.sbatch && [ ! -e batch/submit.sh ] || fail "a changed file stays"
: > file
! "$grade" --for slurm file 2> out || fail "a file in place of the folder is refused"
grep -q '^file: error: ' out || fail "a file in place of the folder: $(cat out)"
echo mine > mine.cpp
mkdir class
! "$grade" class --out results --gradescope mine.cpp 2> out || fail "--gradescope mine.cpp is refused"
grep -q '^mine.cpp: error: is no results.json, and would be replaced$' out || fail "mine.cpp: $(cat out)"
[ "$(cat mine.cpp)" = mine ] && [ ! -e results ] || fail "mine.cpp stays, and nothing is written"
run=$root/source/run_autograder
grep -q -- " --stages 3,5 " "$run" || fail "the stages are in run_autograder"
setup=$root/source/setup.sh
[ -x "$run" ] && [ -x "$setup" ] || fail "both are programs"
for script in "$run" "$setup"; do
    sh -n "$script" || fail "sh -n $script"
    ! command -v shellcheck > /dev/null || shellcheck -e SC2086 "$script" || fail "shellcheck $script"
done

mkdir none
! "$grade" none --out results/deep 2> out || fail "a class without submissions is refused"
[ ! -e results/deep ] || fail "an error in the class leaves no folder of results"

# With a stub for the grader: results.json exists whatever it does.
mkdir -p "$root/source/raysteps/build"
stand_in() { printf '#!/bin/sh\n%s\n' "$1" > "$root/source/raysteps/build/grade"; }
says() {
    grep -qF "$1" "$root/results/results.json" || {
        fail "results.json says \"$1\""
        cat "$root/results/results.json"
    }
}
autograder() { AUTOGRADER=$root RAYSTEPS_SECONDS=1 "$run" > out 2>&1; }
stand_in 'exit 2'
chmod +x "$root/source/raysteps/build/grade"
autograder
says '"score": 0'
says 'The autograder itself failed.'
stand_in 'sleep 30'
autograder
says 'was not graded within 1 s'
stand_in 'kill -9 $$'
autograder
says 'The autograder itself failed.'
stand_in 'for last; do :; done; echo "{\"score\": 3}" > "$last"'
autograder
[ "$(cat "$root/results/results.json")" = '{"score": 3}' ] || fail "the grader's own results.json stays"
rm "$root/source/raysteps/build/grade"
autograder
says 'The autograder itself failed.'
# After a signal from outside, it ends immediately.
stand_in 'sleep 30'
chmod +x "$root/source/raysteps/build/grade"
AUTOGRADER=$root "$run" > out 2>&1 &
runner=$!
sleep 0.5
kill -TERM $runner
wait $runner
says 'The autograder itself failed.'

# On an image with an old CMake and an old g++, newer ones are fetched and used.
tool() {
    printf '#!/bin/sh\n%s\n' "$2" > "$folder/bin/$1"
    chmod +x "$folder/bin/$1"
}
tool dpkg-query 'exit 1'
tool apt-get 'echo "apt-get $*" >> '"$folder/log"
tool cmake 'if [ "$1" = --version ]; then echo "cmake version $(cat '"$folder"'/version)"
            else echo "cmake with ${CXX:-g++}" >> '"$folder/log; fi"
tool python3 'echo "pip $*" >> '"$folder/log; echo 3.31.2 > $folder/version"
tool g++ 'echo 11'
printf 'exit 0\n' > "$root/source/raysteps/course"
set_up() {
    echo "$1" > version
    : > log
    PATH=$folder/bin:$PATH AUTOGRADER=$root sh "$setup" > out 2>&1 || fail "setup.sh with CMake $1"
}
set_up 3.22.1
grep -q '^pip -m pip install cmake>=3.25$' log || fail "CMake 3.22 is replaced"
grep -q '^apt-get install .*g++-12$' log || fail "g++ 11 is replaced"
grep -q '^cmake with g++-12$' log || fail "the newer g++ is used"
tool g++ 'echo 13'
set_up 3.28.3
! grep -q '^pip' log || fail "CMake 3.28 is kept"
grep -q '^cmake with g++$' log || fail "g++ 13 is kept"
exit $failed
