#!/bin/sh
# The value of a table of public answers: by_heart_test.sh BUILD PROJECT STAGE…
#
# For each stage, every query that its suite sends to a student's file is stored in a table, with
# the right answer; then a graded run with an unknown seed tests a worker that has nothing but the
# table. It may get a tenth of all points, and a quarter of a stage's.
build=$(cd "$1" && pwd)
project=$(cd "$2" && pwd)
shift 2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
od -An -N8 -tx8 /dev/urandom > "$folder/seed"
failed=0
all=0
earned=0

fail() {
    echo "FAILED: $1"
    failed=1
}

# points REPORT STAGE: "7 21". 0 points if only the starter's cases pass.
points() {
    awk -v given="$project/steps/$2/starter/passes.txt" '
        BEGIN { while ((getline line < given) > 0) free[line] = 1 }
        /^case / { name = substr($0, 6); worth = 1 }
        /^points / { worth = $2 }
        /^(passed|failed)$/ { most += worth }
        /^passed$/ { sum += worth; if (!(name in free)) own = 1 }
        END { print (own ? sum : 0), most }' "$1"
}

for stage in "$@"; do
    suite=$build/${stage}_asked_test_double
    RAYSTEPS_WORKER=$build/by_heart RAYSTEPS_TABLE=$folder/$stage \
        RAYSTEPS_LEARNS=$build/${stage}_reference_worker \
        "$suite" > /dev/null || fail "$stage: the reference, while it is learned"
    # Tests that the change keeps the table out, and that the table is not empty.
    ask() {
        env "$1" RAYSTEPS_WORKER="$build/by_heart" RAYSTEPS_TABLE="$folder/$stage" \
            RAYSTEPS_STARTER="$build/starters/${stage}_starter_worker" \
            RAYSTEPS_REPORT="$folder/report" "$suite" > /dev/null
        points "$folder/report" "$stage"
    }
    known=$(ask RAYSTEPS_SEED=1)
    [ "${known% *}" -gt 0 ] || fail "$stage: the table knows nothing"
    came=$(ask RAYSTEPS_SEED_FILE="$folder/seed")
    echo "$stage: of ${came#* }, as written ${known% *}, graded ${came% *}"
    [ "${came% *}" -le $((${came#* } / 4)) ] || fail "$stage: more than a quarter by heart"
    earned=$((earned + ${came% *}))
    all=$((all + ${came#* }))
done
echo "all: $earned of $all by heart"
[ $earned -le $((all / 10)) ] || fail "more than a tenth by heart"
exit $failed
