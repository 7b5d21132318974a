#!/bin/sh
# A class of a known quality, graded: class_test.sh BUILD PROJECT [STUDENTS [KILLS [STAGES]]]
#
# Right, untouched, mistaken, empty, uncompilable and hostile submissions, as folders and archives. The
# grader is killed on its way; the grade book must then be the one that was known beforehand, and a
# second run with the same seed must write the same marks, byte for byte. What a mistake is worth is
# known from the suites' other link: the programs of tests/mistakes.
build=$(cd "$1" && pwd)
project=$(cd "$2" && pwd)
students=${3:-12}
kills=${4:-3}
only=${5:-}  # "step03_sphere step13_meshes"
seed=7
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
class=$folder/class
mkdir "$class"
failed=0

fail() {
    echo "FAILED: $1"
    failed=1
}

stages=
for seat in "$build"/seats/step*.o; do
    stage=$(basename "$seat" .o)
    case " ${only:-$stage} " in *" $stage "*) stages="$stages $stage" ;; esac
done
listed=$(echo $stages | tr ' ' ,)
file_of() { echo "${1#step??_}.cpp"; }

# The n-th of some files, around and around.
pick() {
    n=$1
    shift
    shift $((n % $#))
    echo "$1"
}

# A known mistake as a student would hand it in, who has nothing of ours to include but headers.
flattened() {
    awk -v project="$project" '
        /^#include "(steps\/.*\/reference|tests)\// {
            split($0, words, "\"")
            while ((getline line < (project "/" words[2])) > 0) print line
            next
        }
        { print }' "$1"
}

# stage_points REPORT STAGE: what a suite's report is worth. Nothing, if only what the starter passes.
stage_points() {
    awk -v given="$project/steps/$2/starter/passes.txt" '
        BEGIN { while ((getline line < given) > 0) free[line] = 1 }
        /^case / { name = substr($0, 6); worth = 1 }
        /^points / { worth = $2 }
        /^passed$/ { sum += worth; if (!(name in free)) own = 1 }
        END { print own ? sum : 0 }' "$1"
}

points_of_mistake() {
    rm -f "$folder/report"
    RAYSTEPS_SEED=$seed RAYSTEPS_REPORT=$folder/report \
        "$build/mistakes/mistake_$1_$(basename "$2" .cpp)_double" > /dev/null 2>&1
    stage_points "$folder/report" "$1"
}

points_of_reference() {
    rm -f "$folder/report"
    RAYSTEPS_SEED=$seed RAYSTEPS_REPORT=$folder/report "$build/$1_test_double" > /dev/null 2>&1
    stage_points "$folder/report" "$1"
}

# Attacks that may have no more than who wrote nothing.
hostile=
for attack in "$project"/tests/grading/attacks/*.cpp; do
    ! grep -q '^// ceiling: as a stub' "$attack" || grep -q '^// stage: ' "$attack" ||
        hostile="$hostile $attack"
done

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
                points=$(points_of_reference "$stage")
                ;;
            untouched) cp "$project/steps/$stage/starter/"*.cpp "$place" ;;
            mistaken)
                mistake=$(pick "$3" "$project/tests/mistakes/$stage"/*.cpp)
                flattened "$mistake" > "$file"
                points=$(points_of_mistake "$stage" "$mistake")
                ;;
            empty) ;;
            broken) echo "int broken(" > "$file" ;;
            hostile) [ "$stage" != step03_sphere ] || cp "$(pick "$3" $hostile)" "$file" ;;
        esac
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
    case $((number % 12)) in
        0) submit "$name" right $number ;;
        1) submit "$name" untouched $number ;;
        2 | 3 | 4 | 5 | 8 | 9) submit "$name" mistaken $number ;;
        6) submit "$name" empty 0 ;; # an archive of nothing is none
        7) submit "$name" broken $number ;;
        *) submit "$name" hostile $number ;;
    esac
    number=$((number + 1))
done

grade() { "$build/grade" "$class" --out "$1" --seed $seed --stages "$listed" > "$folder/log" 2>&1; }

while [ "$kills" -gt 0 ]; do
    kills=$((kills - 1))
    grade "$folder/results" &
    grader=$!
    sleep "$(awk -v n=$kills 'BEGIN { srand(n); print 3 + 9 * rand() }')"
    pkill -KILL -P $grader grade 2> /dev/null || kill -KILL $grader
    wait $grader 2> /dev/null
done
start=$(date +%s)
grade "$folder/results" || { cat "$folder/log"; fail "the grader"; }
echo "the rest took $(($(date +%s) - start)) s"
sed -e 1d -e 's/\r$//' -e 's/,[0-9]*$//' "$folder/results/grades.csv" > "$folder/came"
diff "$folder/expected" "$folder/came" || fail "the grade book (expected first)"
start=$(date +%s)
grade "$folder/again" || fail "the grader, again"
echo "$students submissions took $(($(date +%s) - start)) s"
(cd "$folder/results" && find . -name '*.jsonl' -o -name '*.png' -o -name '*.csv') | sort > "$folder/files"
while read -r file; do
    cmp -s "$folder/results/$file" "$folder/again/$file" || fail "$file is not the same again"
done < "$folder/files"
echo "$(wc -l < "$folder/files") files are the same again"
exit $failed
