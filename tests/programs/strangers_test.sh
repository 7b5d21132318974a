#!/bin/sh
# Foreign scenes: they look as meant, or a warning contains a remedy: strangers_test.sh BUILD_FOLDER
# PROJECT_FOLDER
build=$1
. "$(dirname "$0")/../lib.sh"
cd "$folder" || exit 1
if [ ! -x "$build/step13_meshes" ]; then
    echo "skipped: step13_meshes is not built"
    exit 77
fi

# draw SCENE OPTIONS…: the scene's text in printf's format.
draw() {
    printf "$1" > scene.rt
    shift
    "$build/step13_meshes" scene.rt -o picture.png --size 64x48 "$@" > out 2> err
}

# blank WORDS SCENE OPTIONS…: a picture of one color, whose warning has these words.
blank() {
    words=$1
    shift
    draw "$@" || fail "$words: a picture is made"
    grep -qF "scene.rt: warning: all pixels have one color: " err && grep -qF -- "$words" err ||
        fail "it is told: $words"
    draw "$@" --quiet || fail "$words: a picture is made quietly"
    [ ! -s err ] || fail "$words: --quiet is quiet"
}

# shows SCENE OPTIONS…: a picture without a warning.
shows() {
    draw "$@" || fail "a picture is made: $1"
    [ ! -s err ] || fail "nothing is wrong with it: $1"
}

# The reason for an empty picture; the suggested remedy shows something.
light='A 0.2 255,255,255\nL 0,9,0 0.5 255,255,255\n'
ball='sp 0,0,-5 2 255,0,0\n'
blank "no shape" "C 0,0,0 0,0,1 60\n$light"
blank "try the direction 0,0,-1 in" "C 0,0,0 0,0,1 60\n$light$ball"
shows "C 0,0,0 0,0,-1 60\n$light$ball"
blank "try the direction " "C 4,6,-3 0,0,1 60\n$light$ball"
draw "C 4,6,-3 0,0,1 60\n$light$ball"
direction=$(sed -n 's/.*try the direction \([^ ]*\) .*/\1/p' err)
shows "C 4,6,-3 $direction 60\n$light$ball"
blank "try --camera 2" "c 0,0,0 0,0,1 60\nc 0,0,0 0,0,-1 60\n$light$ball"
shows "c 0,0,0 0,0,1 60\nc 0,0,0 0,0,-1 60\n$light$ball" --camera 2
blank "field of view is 0" "C 0,0,0 0,0,1 0\n$light$ball"
blank "field of view is 180" "C 0,0,0 0,0,-1 180\n$light$ball"
blank "there is no light" "C 0,0,0 0,0,-1 60\n$ball"
shows "C 0,0,0 0,0,-1 60\n$ball" --shade normal
blank "no light reaches" "C 0,0,0 0,0,-1 60\nL 0,0,-9 1 255,255,255\n$ball"
blank "black in any light" "C 0,0,0 0,0,-1 60\n${light}sp 0,0,-5 2 255,0,0 mirror:1\n"
blank "black in any light" "C 0,0,0 0,0,-1 60\n${light}sp 0,0,-5 2 0,0,0\n"
blank "field of view is 0" "C 0,0,0 0,0,-1 0\n${light}pl 0,0,-5 0,0,1 255,0,0\n"
blank "try the direction " "C 0,0,0 0,0,-1 60\n${light}sp 6,0,-10 2 255,0,0\n" --size 600x1000
blank "--term shows one term" "C 0,0,0 0,0,-1 60\n$light$ball" --term specular
blank "fills the picture" "C 0,0,0 0,0,-1 60\n${light}pl 0,0,-5 0,0,1 255,0,0\n" --term ambient
blank "too small or too far away" "C 0,0,0 0,0,-1 60\n${light}sp 0.160375,-0.160375,-5 0.02 255,0,0\n"
blank "more than white" \
    "C 0,0,0 0,0,-1 60\nA 1 255,255,255\nL 0,0,0 1 255,255,255\npl 0,0,-1 0,0,1 255,255,255\n"
blank "fills the picture" "C 0,0,0 0,0,-1 60\nA 0.5 255,255,255\nsp 0,0,0 2 0,255,0\n"
# In the coordinates of the scene: here its z is up, and its left is right in the picture.
axes='# rt: up=z hand=left\n'
blank "try the direction 0,1,0 in" "$axes${light}C 0,0,0 0,0,1 60\nsp 0,5,0 2 255,0,0\n"
shows "$axes${light}C 0,0,0 0,1,0 60\nsp 0,5,0 2 255,0,0\n"
blank "try the direction 1,0,0 in" "$axes${light}C 0,0,0 0,0,1 60\nsp 5,0,0 2 255,0,0\n"

# Cameras by their number.
cameras='c 0,0,0 0,0,1 60\nc 0,0,0 0,0,-1 60\nc 0,0,3 0,0,-1 30\n'
shows "$cameras$light$ball" --camera 3
grep -aq -- '--camera 3' picture.png || fail "the picture says its camera"
cp picture.png third.png
draw "$cameras$light$ball" --camera 4
[ $? = 2 ] && grep -q 'scene.rt: error: has 3 cameras' err || fail "no camera 4"
draw "$cameras$light$ball" --camera 0
[ $? = 2 ] || fail "cameras are counted from 1"

# Mirrored and rotated: the same bytes as the scene with other coordinates, including a mesh.
printf 'OFF\n4 2 0\n0 0 0\n1 0 0\n0 2 0\n0 0 3\n3 0 1 2\n3 0 1 3\n' > mesh.off
mkdir words ours
scene() { # NAME CAMERA LIGHT SPHERE AXIS MESH MESH_FILE
    printf '%b' "$2\nC $3 60\nA 0.3 255,255,255\nL $4 0.7 255,255,255\nsp $5 1 255,0,0\n" \
        "cy $6 0.5 2 0,255,0\nmesh ../$8 $7 0.5 0,0,255 normals:flat\n" > "$1/scene.rt"
}
same() {
    for side in words ours; do
        (cd $side && "$build/step13_meshes" scene.rt -o picture.png --size 64x48 --quiet)
    done
    cmp -s words/picture.png ours/picture.png || fail "$1"
}
scene words '# rt: hand=left' '1,2,9 -0.1,-0.1,-1' '3,5,4' '1,2,3' '2,0,0 0.6,0.8,0' '-1,0,2' mesh.off
sed 's/^\([1-9]\) 0 0$/-\1 0 0/' mesh.off > mirrored.off
scene ours '#' '-1,2,9 0.1,-0.1,-1' '-3,5,4' '-1,2,3' '-2,0,0 -0.6,0.8,0' '1,0,2' mirrored.off
same "hand=left"
scene words '# rt: up=z' '1,-9,2 -0.1,1,-0.1' '3,-4,5' '1,-3,2' '2,0,0 0.6,0,0.8' '-1,-2,0' mesh.off
printf 'OFF\n4 2 0\n0 0 0\n1 0 0\n0 0 -2\n0 3 0\n3 0 1 2\n3 0 1 3\n' > upright.off
scene ours '#' '1,2,9 -0.1,-0.1,-1' '3,5,4' '1,2,3' '2,0,0 0.6,0.8,0' '-1,0,2' upright.off
same "up=z"

# Many shapes in one place cost as much as one. (In processor seconds.)
awk 'BEGIN {
    print "C 0,0,5 0,0,-1 60\nA 0.5 255,255,255"
    for (i = 0; i < 100000; ++i) print "sp 0,0,0 4 255," i % 256 ",0"
}' > copies.rt
(ulimit -t 6 && "$build/step13_meshes" copies.rt -o copies.png --size 320x240 --quiet) ||
    fail "100,000 spheres in one place"
awk 'BEGIN {
    print "OFF\n3 200000 0\n-9 -9 0\n9 -9 0\n0 9 0"
    for (i = 0; i < 200000; ++i) print "3 0 1 2"
}' > copies.off
printf 'C 0,0,5 0,0,-1 60\nA 0.5 255,255,255\nmesh copies.off 0,0,0 1 255,0,0\n' > copies.rt
(ulimit -t 6 && "$build/step13_meshes" copies.rt -o copies.png --size 320x240 --quiet) ||
    fail "200,000 triangles in one place"

# An error in a mesh contains the scene's line, and so does a warning.
draw 'C 0,0,5 0,0,-1 60\n\nmesh none.off 0,0,0 1 255,0,0\n'
[ $? = 2 ] && [ "$(cat err)" = 'none.off: error: no such file (the mesh of scene.rt:3:1)' ] ||
    fail "a mesh that is not there"
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n' > line.off
draw 'C 0,0,5 0,0,-1 60\nmesh line.off 0,0,0 1 255,0,0\n'
grep -q '^line.off: warning: no triangle has an area.*(the mesh of scene.rt:2:1)$' err ||
    fail "a mesh without area"

# Shapes without a sensible number of digits: every pixel is a number, and a warning has the reason.
for shape in 'sp 1000000,1000000,1000000 .000000000001' \
    'cy 1000000,1000000,1000000 0,1,0 .000000000001 .000000000001' \
    'co 1000000,1000000,1000000 0,1,0 .000000000001 .000000000001'; do
    for precision in float double; do
        for shade in phong normal; do
            draw "C 1000000,1000000,1000000 0,1,-1 60\n$light$shape 255,0,0\n" \
                --precision $precision --shade $shade
            grep -q "not a number" out && fail "$shape, $precision, $shade: a pixel is no number"
            grep -q "surfaces in $precision are off by up to" err ||
                fail "$shape, $precision: it is told that it is lost"
        done
    done
done
# From a point of a surface, that surface is in view only through the shape.
for shape in 'sp 0,0,0 2' 'cy 0,0,0 0,1,0 2 2' 'co 0,1,0 0,-1,0 4 2'; do
    for precision in float double; do
        blank "it points past them" "C 1,0,0 1,0,0 60\n$light$shape 255,0,0\n" \
            --precision $precision
    done
done
large=$(printf '1%0160d' 0)
draw "C 0,0,${large}0 0,0,-1 60\n${light}sp 0,0,0 $large 255,0,0\n"
grep -q 'whose square is out of the range of double; move or scale the scene$' err ||
    fail "lengths whose squares leave the range of double"

exit $failed
