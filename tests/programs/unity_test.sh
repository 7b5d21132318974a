#!/bin/sh
# Each stage's program is linked from unity builds of its parts, without which pictures take up to a
# fifth longer and nothing else changes (common/cmake/stage.cmake): unity_test.sh BUILD PROJECT STAGE…
# Programs and suites of the stages before there are shapes need no choice of settings, and no hierarchy.
build=$1
project=$2
shift 2
. "$(dirname "$0")/../lib.sh"
ls "$project"/steps/*/student/*.cpp > "$folder/student" 2> /dev/null &&
    { echo "with a student's files, programs are linked from separate parts"; exit 77; }
[ -e "$build/build.ninja" ] || { echo "this test needs a build by ninja"; exit 77; }

ninja -C "$build" -t query "$@" > "$folder/programs" || fail "not every stage is a target"
for stage in "$@"; do
    awk -v program="$stage:" '/^[^ ]/ { on = $0 == program } on' "$folder/programs" > "$folder/inputs"
    for precision in f32 f64; do
        sed -n "s|^ *|$build/|; s|\(_unity[a-z_]*_$precision\.dir/Unity/unity_0_cxx\.cxx\)\.o$|\1|p" "$folder/inputs" |
            xargs cat > "$folder/unity" 2> /dev/null
        for part in "steps/$stage/main.cpp" "steps/$stage/reference/" common/render/render.cpp; do
            grep -q "$part" "$folder/unity" || fail "$stage: no unity build in $precision includes $part"
        done
    done
    ! grep "_\(reference\|main\|shared\)_f[36][24]\.dir/" "$folder/inputs" || fail "$stage is linked from separate parts"
done

for stage in step01_ray_generation step02_camera_basis step03_sphere; do
    ninja -C "$build" -t query "$stage" "${stage}_checked" "${stage}_test_float" "${stage}_test_double" > "$folder/inputs" ||
        fail "$stage has a program and suites"
    case $stage in
        step03_sphere) grep -q raysteps_choices "$folder/inputs" && grep -q raysteps_with_shapes "$folder/inputs" ;;
        *) ! grep 'raysteps_choices\|raysteps_with_shapes' "$folder/inputs" ;;
    esac || fail "only from step03_sphere on, there is something to choose: $stage"
done
exit $failed
