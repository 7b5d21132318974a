#!/bin/sh
# Makes the gallery again, or the pictures of one stage: render.sh BUILD_FOLDER [STAGE]
#
# Writes the scenes that make_gallery makes, and docs/gallery/*.png, each by the program of its stage.
# The whole takes ten minutes on two cores; tests/programs/gallery_test.sh compares small
# pictures with these.
build=$1
only=$2
folder=$(cd "$(dirname "$0")" && pwd) || exit 1
pictures=$folder/../../docs/gallery

# picture PROGRAM SCENE PICTURE OPTION...
picture() {
    program=$1 scene=$2 name=$3
    shift 3
    case ${only:-$program} in
        "$program" | "$(echo "$program" | sed 's/^step0*\([0-9]*\)_.*/\1/')")
            "$build/$program" "$folder/$scene.rt" -o "$pictures/$name.png" --gamma srgb "$@" || exit 1 ;;
    esac
}

for name in $("$build/make_gallery" --list); do
    "$build/make_gallery" "$name" > "$folder/$name.rt" || exit 1
done
for scene in "$folder"/step*.rt; do
    name=$(basename "$scene" .rt)
    samples=16
    [ "$name" != step11_soft_shadows ] || samples=64  # its wide penumbrae are grainy with 16
    picture "$name" "$name" "$name" --samples $samples
done
# One scene through the course.
picture step06_square cornell cornell_torch --samples 16
picture step09_phong cornell cornell_phong --samples 16
picture step10_shadows cornell cornell_shadows --samples 16
picture step11_soft_shadows cornell_soft_shadows cornell_soft_shadows --samples 16
picture step12_mirror cornell_mirror cornell_mirror --samples 16
picture step13_meshes cornell_mesh cornell_mesh --samples 16
# The camera goes around the owls.
picture step13_meshes turntable turntable --samples 4 --shadow-samples 8 --turn 24
