#!/bin/sh
# The grading of a class with known results: class_test.sh BUILD PROJECT [STUDENTS [KILLS [STAGES]]]
#
# Right, untouched, mistaken, empty, uncompilable and hostile submissions, as folders and archives.
# The grader is killed during the run; the grade book must then equal the one known beforehand, and
# a second run with the same seed must write the same marks, byte for byte. The points of a mistake
# are those of the same suites, run without the grader and its sandbox.
build=$(cd "$1" && pwd)
project=$(cd "$2" && pwd)
students=${3:-12}
kills=${4:-3}
only=${5:-}  # "step03_sphere step13_meshes"
SOURCE_DATE_EPOCH=0  # a fixed date for the class report
export SOURCE_DATE_EPOCH
. "$(dirname "$0")/../lib.sh"
class=$folder/class
seed=$folder/seed
echo 9d0f5a37c1e86b24 > "$seed"
mkdir "$class" "$folder/reports"

stages=
for seat in "$build"/seats/step*.o; do
    stage=$(basename "$seat" .o)
    case " ${only:-$stage} " in *" $stage "*) stages="$stages $stage" ;; esac
done
listed=$(echo $stages | tr ' ' ,)
file_of() { echo "${1#step??_}.cpp"; }

# The n-th of some files, cyclically.
pick() {
    n=$1
    shift
    shift $((n % $#))
    echo "$1"
}

# stage_points REPORT SUITE: the points of a suite's report. 0 if only the starter's cases pass.
stage_points() {
    awk -v given="$project/steps/${2%_trace}/starter/passes.txt" '
        BEGIN { while ((getline line < given) > 0) free[line] = 1 }
        /^case / { name = substr($0, 6); worth = 1 }
        /^points / { worth = $2 }
        /^passed$/ { sum += worth; if (!(name in free)) own = 1 }
        END { print own ? sum : 0 }' "$1"
}

# points_of WORKER SUITE [ANSWER]: computed once, however many students submit the same.
points_of() {
    report=$folder/reports/$(basename "$1")_$2_${3-}
    [ -e "$report" ] ||
        RAYSTEPS_ANSWER=${3-} RAYSTEPS_SEED_FILE=$seed RAYSTEPS_REPORT=$report RAYSTEPS_WORKER=$1 \
            "$build/${2}_asked_test_double" > /dev/null 2>&1
    stage_points "$report" "$2"
}

# Attacks that may get no more points than the starter, and are of stage 3.
hostile=$(awk '
    /^attack / { name = substr($2, 1, length($2) - 1); bad = 0 }
    /^stage: / { name = "" }
    /^ceiling: as a stub/ { bad = 1 }
    /^$/ { if (name != "" && bad) print name; name = "" }' "$project"/tests/grading/attacks/*.txt | sort)

# section KIND NAME: the source of an attack, or of a part that attacks name.
section() {
    awk -v kind="$1" -v name="$2" '
        $1 == "attack" || $1 == "part" { is_in = $1 == kind && ($2 == name || $2 == name ":"); is_text = 0; next }
        is_in && is_text { print }
        /^$/ { is_text = 1 }' "$project"/tests/grading/attacks/*.txt
}

# whole_attack NAME: the attack, and the parts that it names.
whole_attack() {
    section attack "$1" | while IFS= read -r line; do
        case $line in
            @[a-z]*@) for part in $(echo "$line" | tr -d @); do section part "$part"; done ;;
            *) printf '%s\n' "$line" ;;
        esac
    done
}

# submit NAME KIND NUMBER: its folder, and its line of the grade book.
submit() {
    place=$class/$1
    mkdir -p "$place"
    line=$1
    total=0
    for stage in $stages; do
        file=$place/$(file_of "$stage")
        points=0
        case $2 in
            right)
                cp "$project/steps/$stage/reference/"*.cpp "$place"
                points=$(points_of "$build/${stage}_reference_worker" "$stage")
                right=$(sed -n 's|^// right \([^:]*\):.*|\1|p' "$project/tests/alternatives/${stage}_trace.cpp" | head -n 1)
                if [ -n "$right" ]; then
                    "$build/known_mistakes" "$project" "${stage}_trace" "$right" > "${file%.cpp}_main.cpp"
                    points=$((points + $(points_of "$build/${stage}_reference_worker" "${stage}_trace")))
                fi
                ;;
            untouched) cp "$project/steps/$stage/starter/"*.cpp "$place" ;;
            mistaken)
                mistakes=$(sed -n 's/^mistake \([^ ]*\).*/\1/p' "$project/tests/mistakes/$stage.txt")
                n=$3
                while  # the first one from there on that includes no file of the tests
                    mistake=$(pick "$n" $mistakes)
                    "$build/known_mistakes" "$project" "$stage" "$mistake" > "$file"
                    grep -q '#include "tests/' "$file"
                do n=$((n + 1)); done
                points=$(points_of "$build/${stage}_answers_worker" "$stage" "$mistake")
                ;;
            empty) ;;
            broken) echo "int broken(" > "$file" ;;
            hostile) [ "$stage" != step03_sphere ] || whole_attack "$(pick "$3" $hostile)" > "$file" ;;
        esac
        # Makes every file unique: identical files are graded once.
        [ ! -e "$file" ] || echo "// $1" >> "$file"
        line=$line,$points
        total=$((total + points))
    done
    echo "$line,$total" >> "$folder/expected"
    case $(($3 % 3)) in
        1) (cd "$place" && cmake -E tar czf "../$1.tar.gz" -- * && cd .. && rm -rf "$1") ;;
        2) (cd "$place" && cmake -E tar cf "../$1.zip" --format=zip -- * && cd .. && rm -rf "$1") ;;
    esac
}

number=0
while [ $number -lt "$students" ]; do
    name=$(printf 's%03d' $number)
    case $((number % 12)) in  # the first seven are of all kinds
        0) submit "$name" right $number ;;
        1) submit "$name" untouched $number ;;
        3 | 10) submit "$name" hostile $number ;;
        4) submit "$name" empty 0 ;;  # an archive without files is empty
        6) submit "$name" broken $number ;;
        *) submit "$name" mistaken $number ;;
    esac
    number=$((number + 1))
done

# The processor time of this shell's children, in seconds: $used.
look_at_times() {
    times > "$folder/times"
    used=$(awk -F '[ms ]' 'END { printf "%d", $1 * 60 + $2 + $4 * 60 + $5 }' "$folder/times")
}

grade() { "$build/grade" "$class" --out "$1" --seed-file "$seed" --stages "$listed" > "$folder/log" 2>&1; }

# A third while the references are graded, the others soon after that.
while [ "$kills" -gt 0 ]; do
    kills=$((kills - 1))
    : > "$folder/log"
    grade "$folder/results" &
    grader=$!
    until [ $((kills % 3)) = 0 ] || grep -q ', seed ' "$folder/log" ||
        ! kill -0 $grader 2> /dev/null; do
        sleep 0.1
    done
    sleep "$(awk -v n=$kills -v all="$students" 'BEGIN { srand(n); print (3 + all / 12) * rand() }')"
    pkill -KILL -P $grader grade 2> /dev/null || kill -KILL $grader
    wait $grader 2> /dev/null
done
grade "$folder/results" || { cat "$folder/log"; fail "the grader"; }
# The student, the stages and the sum; what they are out of, and remarks, follow.
sed -e 1d -e 's/\r$//' "$folder/results/grades.csv" |
    cut -d , -f "1-$(($(echo "$stages" | wc -w) + 2))" > "$folder/came"
diff "$folder/expected" "$folder/came" || fail "the grade book (expected first)"
start=$(date +%s)
look_at_times
before=$used
grade "$folder/again" || fail "the grader, again"
look_at_times
echo "$students submissions took $(($(date +%s) - start)) s, $((used - before)) s of the processors'"
(cd "$folder/results" && find . -type f) | sort > "$folder/files"
while read -r file; do
    cmp -s "$folder/results/$file" "$folder/again/$file" || fail "$file is not the same again"
done < "$folder/files"
echo "$(wc -l < "$folder/files") files are the same again"

# The reports name the version, and need no program for it.
mkdir "$folder/no_programs"
PATH=$folder/no_programs "$build/grade" --report --out "$folder/again" > "$folder/log" 2>&1 ||
    { cat "$folder/log"; fail "the reports without a program"; }
grep -q 'Raysteps [0-9]*\.[0-9]*\.[0-9]' "$folder/again/class.html" || fail "the version is named"

# After a signal, the grader ends within 2 s, or 10 s on a busy machine, and leaves nothing in the
# temporary folder.
mkdir "$folder/tmp"
chmod 711 "$folder"  # the compiler runs as an unprivileged user, and must be able to enter it
for signal in INT TERM; do
    : > "$folder/log"
    # With its own handler: a background process of a shell ignores SIGINT otherwise.
    TMPDIR=$folder/tmp "$build/grade" "$class" --out "$folder/stopped_$signal" --seed-file "$seed" --stages "$listed" \
        > "$folder/log" 2>&1 &
    grader=$!
    sleep 2
    start=$(date +%s%N)
    kill -$signal $grader
    wait $grader
    [ $? = 1 ] || fail "$signal: exit status"
    [ $((($(date +%s%N) - start) / 1000000)) -lt 10000 ] || fail "$signal is not obeyed"
    [ -z "$(ls "$folder/tmp")" ] || fail "$signal leaves $(ls "$folder/tmp")"
done

# If the grader itself fails for one student, the reason is reported, and the next one is graded.
file=$(file_of "${stages##* }")
mkdir -p "$folder/hindered/students/s000/submitted/$file/in_the_way"
"$build/grade" "$class" --out "$folder/hindered" --seed-file "$seed" --stages "$listed" --student s000 \
    --student s001 > "$folder/log" 2>&1
[ $? = 2 ] || fail "the status of a run that could not judge one"
grep -q '^error: s000 could not be graded: ' "$folder/log" || fail "who could not be judged"
for name in s000 s001; do
    grep -q "^$name," "$folder/hindered/grades.csv" || fail "$name is not in the grade book"
done
grep -q 'could not be graded' "$folder/hindered/students/s000/feedback.html" || fail "the reason"
exit $failed
