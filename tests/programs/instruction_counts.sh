#!/bin/sh
# Features that a scene does not use cost nothing: instruction_counts.sh BUILD_FOLDER PROJECT_FOLDER
#
# The same scene is rendered by the first stage with all its features and by later stages, with more
# features: shadows, area lights, mirrors, meshes. The number of executed instructions for the
# picture may differ by 1 %. The instructions before the first pixel, such as for reading the
# options, are subtracted: they are those for a picture of one pixel of the stage's first scene here.
# Needs valgrind; status 77 if it is not installed.
build=$1
scenes=$2/scenes
if ! valgrind --version > /dev/null 2>&1; then
    echo "skipped: valgrind, which counts instructions, is not installed (apt-get install valgrind)"
    exit 77
fi
. "$(dirname "$0")/../lib.sh"
cd "$folder" || exit 1

# instructions STAGE SCENE PRECISION SIZE: the number for a picture; nothing if there is no picture.
instructions() {
    valgrind --tool=callgrind --callgrind-out-file=/dev/null "$build/$1" "$2.rt" \
        --precision "$3" --size "$4" --threads 1 --quiet -o picture.png > out 2>&1 &&
        sed -n 's/^==[0-9]*== Collected : *\([0-9]*\)$/\1/p' out
}

# cost STAGE SCENE PRECISION: the instructions from the first pixel on. Each is counted once.
cost() {
    kept=$1.$2.$3
    start=$1.$3
    [ -s "$start" ] || instructions "$1" "$2" "$3" 1x1 > "$start"
    [ -e "$kept" ] || {
        picture=$(instructions "$1" "$2" "$3" 32x24)
        [ -n "$picture" ] && [ -s "$start" ] && echo $((picture - $(cat "$start"))) > "$kept"
    }
    cat "$kept" 2> /dev/null
}

cp "$scenes"/step*.rt .
grep -v '^L' step09_phong.rt > ambient.rt

# same_cost SCENE STAGE…: every built stage against the first, in both precisions.
same_cost() {
    scene=$1
    shift
    for precision in double float; do
        base=
        for stage in "$@"; do
            [ -x "$build/$stage" ] || continue
            count=$(cost "$stage" "$scene" $precision)
            if [ -z "$count" ]; then
                fail "$stage does not draw $scene.rt under valgrind"
                continue
            fi
            [ -n "$base" ] || base=$count
            awk "BEGIN {
                more = 100 * ($count - $base) / $base
                printf \"%-20s %-7s %-20s %11d %+7.2f %%\", \"$scene\", \"$precision\", \"$stage\", $count, more
                wrong = more > 1 || more < -1
                print wrong ? \"  FAILED: more than 1 %\" : \"\"
                exit wrong
            }" || failed=1
        done
    done
}

printf '%-20s %-7s %-20s %s\n' scene numbers stage instructions
same_cost ambient step09_phong step10_shadows step11_soft_shadows step12_mirror step13_meshes
same_cost step09_phong step10_shadows step11_soft_shadows step12_mirror  # no area light, no mirror
same_cost step09_phong step12_mirror step13_meshes                       # no mesh
same_cost step10_shadows step10_shadows step11_soft_shadows step12_mirror
same_cost step10_shadows step12_mirror step13_meshes
same_cost step11_soft_shadows step11_soft_shadows step12_mirror
same_cost step12_mirror step12_mirror step13_meshes

exit $failed
