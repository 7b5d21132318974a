#!/bin/sh
# The pictures of the gallery are those of its scenes: gallery_test.sh BUILD_FOLDER PROJECT_FOLDER
#
# Each scene is read strictly and rendered small, with few samples, by the program of its stage, and
# compared with the picture of docs/gallery. Scenes of many shapes are those that make_gallery makes.
build=$1
project=$2
. "$(dirname "$0")/../lib.sh"
scenes=$project/scenes/gallery

[ "$("$build/make_gallery" --list | wc -l)" -ge 7 ] || fail "make_gallery --list"
for name in $("$build/make_gallery" --list); do
    "$build/make_gallery" "$name" > "$folder/made.rt" && cmp "$folder/made.rt" "$scenes/$name.rt" ||
        fail "$name.rt is what make_gallery makes"
done
"$build/make_gallery" unicorn > "$folder/out" 2> "$folder/err"
[ $? = 2 ] && [ ! -s "$folder/out" ] && grep -q '^error: ' "$folder/err" ||
    fail "make_gallery unicorn: status 2, and an error"

# is_current PROGRAM SCENE PICTURE SIZE
is_current() {
    [ -x "$build/$1" ] || return  # stage 13 without OpenMesh
    "$build/$1" "$scenes/$2.rt" --strict --size "$4" --samples 9 --gamma srgb --quiet \
        -o "$folder/small.png" > "$folder/out" 2> "$folder/err" && [ ! -s "$folder/err" ] ||
        fail "$1 renders scenes/gallery/$2.rt, without a warning"
    "$build/shrunk_difference" "$folder/small.png" "$project/docs/gallery/$3.png" > "$folder/out" 2> "$folder/err" &&
        awk '{ exit !($1 < 5 && $2 < 14) }' "$folder/out" ||
        fail "docs/gallery/$3.png is current (sh scenes/gallery/render.sh build makes it): mean and worst tile differ by"
}
for scene in "$scenes"/step*.rt; do
    name=$(basename "$scene" .rt)
    is_current "$name" "$name" "$name" 160x120
done
is_current step06_square cornell cornell_torch 160x160
is_current step09_phong cornell cornell_phong 160x160
is_current step10_shadows cornell cornell_shadows 160x160
is_current step11_soft_shadows cornell_soft_shadows cornell_soft_shadows 160x160
is_current step12_mirror cornell_mirror cornell_mirror 160x160
is_current step13_meshes cornell_mesh cornell_mesh 160x160

is_current step13_meshes turntable turntable 160x120  # its first picture

# The whole gallery stays small enough for a clone.
size=$(cat "$project"/docs/gallery/*.png | wc -c)
[ "$size" -lt 12000000 ] || fail "the gallery is smaller than 12 MB, not $size"
exit $failed
