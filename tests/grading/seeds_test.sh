#!/bin/sh
# A right answer passes with every seed: seeds_test.sh BUILD SUITE…
#
# A graded run moves the scenes and the shapes of all fixed cases by motions from its seed, and ends
# if the reference then fails. Each suite tests its stage's reference with these seeds. With the
# last two, a case failed whose ray left a mirror along another: only rounding decided whether it
# met that one.
build=$(cd "$1" && pwd)
shift
. "$(dirname "$0")/../lib.sh"
seeds="243f6a8885a308d3 b236a50503e93865 47a3842b6a584dfa"

for suite in "$@"; do
    for seed in $seeds; do
        echo "$seed" > "$folder/seed"
        RAYSTEPS_SEED_FILE=$folder/seed RAYSTEPS_WORKER=$build/${suite%_trace}_reference_worker \
            "$build/${suite}_asked_test_double" > "$folder/log" 2>&1 ||
            { cat "$folder/log"; fail "$suite: the reference with seed $seed"; }
    done
done
exit ${failed:-0}
