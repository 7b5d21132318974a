#!/bin/sh
# matrix.sh [stage] [build folder] [log]: runs every known mistake of a stage, or of all, and prints
# the case of the stage's suite that catches it, for each precision: in float for the first of each
# suite only. All must be built. With the log of a run of ctest, it runs nothing.
set -u
root=$(CDPATH='' cd -- "$(dirname "$0")/.." && pwd -P) || exit 2
build=${2-$root/build}
case ${1-all} in
    all) stage=step ;;
    [1-9] | 1[0-9]) stage=$(printf 'step%02d_' "$1") ;;
    *) stage=$(basename "$root"/tests/mistakes/*"$1".txt .txt) ;;
esac

log=${3-}
[ -n "$log" ] || {
    log=$(mktemp) || exit 2
    trap 'rm -f "$log"' EXIT
    ctest --test-dir "$build" -R "^mistake_$stage" -j "$(nproc)" > "$log" 2>&1
}

# "1/38 Test #7: mistake_step04_plane_one_side_float ....   Passed    0.01 sec"
# Those of a stage's trace are in a text of their own; their suite is stepNN_…_trace.
for file in "$root"/tests/mistakes/"$stage"*.txt; do
    sed -n -e "s/^mistake \([a-z0-9_]*\) .*/$(basename "$file" .txt)\t\1/; t keep" \
        -e 's/^caught by: //; t join' -e d -e :keep -e h -e d -e :join -e H -e x -e 's/\n/\t/p' "$file"
done | awk -F '\t' -v log_file="$log" '
    function mark(name, otherwise) {
        if (!(name in passed)) return otherwise
        ++tested
        caught += passed[name]
        return passed[name] ? "yes" : "NO"
    }
    BEGIN {
        while ((getline line < log_file) > 0)
            if (match(line, /mistake_[a-z0-9_]+/))
                passed[substr(line, RSTART, RLENGTH)] = line ~ / Passed /
    }
    $1 != stage {
        stage = $1
        printf "%s%-34s float  double  caught by\n", (NR > 1 ? "\n" : ""), stage
    }
    {
        name = "mistake_" $1 "_" $2
        printf "  %-32s %-5s  %-6s  %s\n", $2, mark(name "_float", "-"), mark(name "_double", "?"), $3
        ++mistakes
        missing += !((name "_double") in passed)
    }
    END {
        printf "\n%d mistakes, %d of %d caught\n", mistakes, caught, tested + missing
        exit mistakes == 0 || caught != tested + missing
    }'
