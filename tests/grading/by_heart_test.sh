#!/bin/sh
# The value of a table of public answers: by_heart_test.sh BUILD PROJECT STAGE…
#
# step09_phong_trace is the `trace` of that stage. For each stage, every query that its suite sends to a student's file is stored in a table, with
# the right answer. A graded run with an unknown seed then tests a worker that has nothing but the
# table, and one that also recognizes the numbers of its queries, except for signs, order and powers
# of two, and then has the right answer. Neither may get more than a tenth of a stage's points,
# rounded down.
build=$(cd "$1" && pwd)
project=$(cd "$2" && pwd)
shift 2
. "$(dirname "$0")/../lib.sh"
od -An -N8 -tx8 /dev/urandom > "$folder/seed"

# points REPORT STAGE: "7 21". 0 points if only the starter's cases pass.
points() {
    awk -v given="$project/steps/${2%_trace}/starter/passes.txt" '
        BEGIN { while ((getline line < given) > 0) free[line] = 1 }
        /^case / { name = substr($0, 6); worth = 1 }
        /^points / { worth = $2 }
        /^(passed|failed)$/ { most += worth }
        /^passed$/ { sum += worth; if (!(name in free)) own = 1 }
        END { print (own ? sum : 0), most }' "$1"
}

for stage in "$@"; do
    suite=$build/${stage}_asked_test_double
    RAYSTEPS_SEED=1 RAYSTEPS_WORKER=$build/by_heart RAYSTEPS_TABLE=$folder/$stage \
        RAYSTEPS_LEARNS=$build/${stage%_trace}_reference_worker \
        "$suite" > /dev/null || fail "$stage: the reference, while it is learned"
    # ask VARIABLE=VALUE…: the points with these.
    ask() {
        env "$@" RAYSTEPS_WORKER="$build/by_heart" RAYSTEPS_TABLE="$folder/$stage" \
            RAYSTEPS_STARTER="$build/starters/${stage}_starter_worker" \
            RAYSTEPS_REPORT="$folder/report" "$suite" > /dev/null
        points "$folder/report" "$stage"
    }
    again=$(ask RAYSTEPS_SEED=1)  # tests that the table is not empty
    written=$(ask RAYSTEPS_SEED=2)
    came=$(ask RAYSTEPS_SEED_FILE="$folder/seed")
    alike=$(ask RAYSTEPS_SEED_FILE="$folder/seed" RAYSTEPS_ALIKE="$build/${stage%_trace}_reference_worker")
    echo "$stage: of ${came#* }, the same again ${again% *}, as written ${written% *}," \
        "graded ${came% *}, alike ${alike% *}"
    [ "${again% *}" -gt $((${came#* } / 2)) ] || fail "$stage: the table knows less than half"
    tenth=$((${came#* } / 10))
    [ "${came% *}" -le $tenth ] || fail "$stage: more than a tenth by heart"
    [ "${alike% *}" -le $tenth ] || fail "$stage: more than a tenth by heart, signs, order and powers of two undone"
done
exit $failed
