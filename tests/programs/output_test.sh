#!/bin/sh
# Destinations of pictures, allowed and refused: output_test.sh BUILD_FOLDER PROJECT_FOLDER
build=$1
project=$2
. "$(dirname "$0")/../lib.sh"
cd "$folder" || exit 1

# picture_of SIZE FILE: true for a PNG of this size, "width height" in hexadecimal.
picture_of() {
    [ "$(od -An -tx1 -N24 "$2" | tr -d ' \n')" = "89504e470d0a1a0a0000000d49484452$1" ]
}

# refused WHAT PICTURE: status 2, one line, and no part of a picture.
refused() {
    "$build/step03_sphere" own.rt --size 64x48 -o "$2" > out 2> err
    [ $? = 2 ] || fail "$1: the status is 2"
    grep -q ': error: ' err && [ "$(wc -l < err)" = 1 ] || fail "$1: says so in one line"
    [ ! -s out ] || fail "$1: says nothing else"
    [ -z "$(find . -name '*.part')" ] || fail "$1: leaves no part of a picture"
}

cp "$project/scenes/one_sphere.rt" own.rt

# Without arguments: the stage's scene, to the project's renders/, from any folder.
rm -f "$project/renders/step03_sphere.png"
"$build/step03_sphere" > out 2> err || fail "the stage's own scene is drawn"
grep -q 'renders/step03_sphere.png: 640 x 480 pixels, double, ' out || fail "it says where"
picture_of 00000280000001e0 "$project/renders/step03_sphere.png" || fail "it is 640 x 480"

mkdir gone && cd gone && rmdir ../gone
"$build/step03_sphere" --pixel 0,0 > "$folder/out" 2> "$folder/err" || fail "from a folder that is gone"
cd "$folder" || exit 1

# -o creates the folders. The last of two -o counts, and of two sizes.
"$build/step03_sphere" own.rt -o a.png -o "new/très bon/a b.png" --size 1x1 --size 3x2 > out 2> err
picture_of 0000000300000002 "new/très bon/a b.png" || fail "-o makes folders"
[ ! -e a.png ] || fail "the last -o counts"
for precision in float double; do
    "$build/step03_sphere" own.rt -o $precision.png --precision $precision --size 3x2 > out 2> err
    grep -q "^$precision.png: 3 x 2 pixels, $precision, " out || fail "$precision says so"
    picture_of 0000000300000002 $precision.png || fail "$precision makes a picture"
done

# An invalid destination is refused, before the work and without harm.
refused "a folder" new
refused "a folder's name" other/
refused "a file for a folder" own.rt/a.png
refused "a device" /dev/null
[ -c /dev/null ] || fail "a device stays one"
refused "the standard output" -
grep -q 'the standard output$' err || fail "- is not the standard output, and the error says so"
if [ -e /dev/stdout ]; then
    { "$build/step03_sphere" own.rt --size 4x3 -o /dev/stdout 2> err; echo $? > status; } | cat > out
    [ "$(cat status)" = 2 ] && [ ! -s out ] || fail "/dev/stdout in a pipe: status 2, and nothing in the pipe"
    grep -q '^/dev/stdout: error: is not the name of a file: ' err && [ "$(wc -l < err)" = 1 ] ||
        fail "/dev/stdout in a pipe: the error says what is wrong"
fi
mkfifo fifo.png
refused "a named pipe" fifo.png
[ -p fifo.png ] || fail "a named pipe stays one"
ln -s own.rt linked.rt
refused "the scene itself" ./own.rt
for name in a.jpg a.png.gif a fresh/a png; do
    refused "a name without .png: $name" $name
    grep -q 'must end in .png$' err && [ ! -e $name ] && [ ! -e fresh ] || fail "the name's ending: $name"
done
refused "the scene by another name" linked.rt
cmp -s own.rt "$project/scenes/one_sphere.rt" || fail "the scene is as it was"

# On a full disk, or at a size limit, the old picture stays.
"$build/step03_sphere" own.rt -o old.png --size 8x6 --quiet
cp old.png kept.png
(
    trap '' XFSZ
    ulimit -f 1
    "$build/step03_sphere" own.rt -o old.png --size 640x480 2> /dev/null > /dev/null
    [ $? = 2 ]
) || fail "no room for the picture: the status is 2"
cmp -s old.png kept.png || fail "no room for the picture: the old one stays"
[ -z "$(find . -name '*.part')" ] || fail "no room for the picture: no part of it is left"
(
    ulimit -f 1  # by default the signal kills the program
    "$build/step03_sphere" own.rt -o old.png --size 640x480 2> err > /dev/null
    [ $? = 2 ]
) || fail "a limit for files: the status is 2"
grep -q '^old.png: error: ' err || fail "a limit for files: it is told"
cmp -s old.png kept.png || fail "a limit for files: the old picture stays"
[ -z "$(find . -name '*.part')" ] || fail "a limit for files: no part of a picture is left"

# Output that cannot be written changes the exit status.
unheard() {
    "$build/step03_sphere" own.rt --size 64x48 "$@" > /dev/full 2> err
    [ $? = 2 ] || fail "$*: nobody heard it, and the status is 2"
    grep -q '^error: the standard output cannot be written' err && [ "$(wc -l < err)" = 1 ] ||
        fail "$*: nobody heard it, and that is told in one line"
}
if [ -c /dev/full ]; then
    unheard --pixel 0,0
    unheard --requirements
    unheard --help
    unheard -o unheard.png
fi
"$build/step03_sphere" own.rt --pixel 0,0 >&- 2> err
[ $? = 2 ] && [ -s err ] || fail "nobody is there to hear it"

# An empty name is an error.
"$build/step03_sphere" own.rt --size 64x48 -o "" > out 2> err
[ $? = 2 ] && [ "$(wc -l < err)" = 1 ] || fail "an output of an empty name"
"$build/step03_sphere" "" -o nothing.png > out 2> err
[ $? = 2 ] && [ "$(wc -l < err)" = 1 ] && [ ! -e nothing.png ] || fail "a scene of an empty name"

# Files other than pictures stay: sources, scenes, meshes, with any name.
echo 'int main() {}' > triangle.cpp
cp own.rt other.rt
ln own.rt hard.rt
ln -s "$folder/other.rt" far.png
for file in triangle.cpp other.rt hard.rt far.png; do
    cp "$file" before
    refused "a file of somebody's, $file" "$file"
    cmp -s before "$file" || fail "$file is as it was"
done
: > empty.png
"$build/step03_sphere" own.rt -o empty.png --size 3x2 --quiet || fail "an empty file is a place"
picture_of 0000000300000002 empty.png || fail "an empty file becomes a picture"

# --turn makes an animated PNG, in which the first picture is that without --turn.
"$build/step03_sphere" own.rt -o turn.png --size 16x12 --turn 3 > out 2> err || fail "--turn 3"
picture_of 000000100000000c turn.png && grep -q '^turn.png: 3 frames of 16 x 12 pixels' out ||
    fail "--turn 3 tells its frames"
[ "$(grep -ao fcTL turn.png | wc -l)" = 3 ] && grep -aq acTL turn.png || fail "--turn 3 has three frames"
cp turn.png before
for words in "--turn 1" "--turn 361" "--turn two" "--turn 3 --preview" "--turn 3 --time 1"; do
    # shellcheck disable=SC2086
    "$build/step03_sphere" own.rt -o turn.png --size 16x12 $words > out 2> err
    [ $? = 2 ] && [ ! -s out ] && [ "$(wc -l < err)" = 1 ] && grep -q -- '--turn' err ||
        fail "$words: status 2, and an error in one line"
done
cmp -s before turn.png || fail "a wrong --turn leaves the older file"
printf 'C 0,1,0 0,0,-1 60\npl 0,0,0 0,1,0 9,9,9\n' > plane.rt
"$build/step04_plane" plane.rt -o plane.png --turn 3 > out 2> err
[ $? = 2 ] && [ ! -e plane.png ] && grep -q '^plane.rt: error: .* --turn' err || fail "--turn without a middle"
"$build/step03_sphere" own.rt -o own.rt --turn 3 2> err && fail "--turn overwrites the scene"
cmp -s own.rt "$project/scenes/one_sphere.rt" || fail "--turn: the scene is as it was"

# Neighboring files stay, also a scene with that name and a link.
cp own.rt neighbor.png.part
cp own.rt precious
ln -s precious linked.png.part
"$build/step03_sphere" neighbor.png.part -o neighbor.png --size 3x2 --quiet || fail "an odd name"
"$build/step03_sphere" own.rt -o linked.png --size 3x2 --quiet || fail "a link beside it"
cmp -s own.rt neighbor.png.part && cmp -s own.rt precious || fail "neighbors are as they were"
rm neighbor.png.part linked.png.part

# Without permission nothing is written; a write-protected picture stays.
if [ "$(id -u)" != 0 ]; then
    mkdir locked
    chmod a-w locked old.png
    refused "a folder that is locked" locked/a.png
    refused "a picture that is locked" old.png
    chmod u+w locked old.png
fi

# Several at once: each writes a whole picture.
for turn in 1 2 3 4 5; do
    for size in 64x48 32x24 16x12; do
        "$build/step03_sphere" own.rt -o race.png --size $size --quiet --threads 1 2>> race.err &
    done
    wait
    case $(od -An -tx1 -N24 race.png | tr -d ' \n') in
        89504e470d0a1a0a0000000d494844520000004000000030) size=64x48 ;;
        89504e470d0a1a0a0000000d494844520000002000000018) size=32x24 ;;
        *) size=16x12 ;;
    esac
    "$build/step03_sphere" own.rt -o alone.png --size $size --quiet
    cmp -s race.png alone.png || fail "one of several, whole"
done
[ ! -s race.err ] || fail "several at once: each is content"
[ -z "$(find . -name '.raysteps-*')" ] || fail "several at once leave nothing behind"

# Meshes are inputs too.
if [ -x "$build/step13_meshes" ]; then
    mkdir meshes
    cp "$project/scenes/meshes/cube.off" meshes/cube.off
    printf 'C 0,0,5 0,0,-1 60\nmesh meshes/cube.off 0,0,0 1 255,0,0\n' > mesh.rt
    ln meshes/cube.off hard.off
    for file in meshes/cube.off ./meshes/../meshes/cube.off hard.off; do
        "$build/step13_meshes" mesh.rt -o $file --size 8x6 > out 2> err
        [ $? = 2 ] && [ "$(wc -l < err)" = 1 ] || fail "a mesh of the scene: $file"
    done
    cmp -s meshes/cube.off "$project/scenes/meshes/cube.off" || fail "a mesh is as it was"
    # A binary STL may start like a PNG: 80 arbitrary bytes, a number, one triangle.
    { printf '\211PNG\r\n\032\n'; head -c 72 /dev/zero; printf '\001\000\000\000'; head -c 24 /dev/zero
        printf '\000\000\200\077'; head -c 12 /dev/zero; printf '\000\000\200\077'; head -c 6 /dev/zero; } > png.stl
    sed 's#meshes/cube.off#png.stl#' mesh.rt > stl.rt
    cp png.stl png.before
    ln -s png.stl stl.png
    "$build/step13_meshes" stl.rt -o stl.png > out 2> err
    [ $? = 2 ] && grep -q 'is a mesh of the scene' err || fail "a mesh that looks like a picture"
    cmp -s png.stl png.before || fail "that mesh is as it was"

    # An endless or unreadable file is not a mesh, and the error is immediate.
    ln -s /dev/zero zero.off
    mkfifo pipe.off
    memory=400000
    # Sanitizers need more memory.
    (ulimit -v $memory && "$build/step13_meshes" --help) > /dev/null 2>&1 || memory=unlimited
    for file in zero.off pipe.off; do
        printf 'C 0,0,5 0,0,-1 60\nmesh %s 0,0,0 1 255,0,0\n' $file > odd.rt
        (ulimit -v $memory && timeout 5 "$build/step13_meshes" odd.rt -o odd.png) > out 2> err
        [ $? = 2 ] && grep -q "^$file: error: .*odd.rt:2:1" err || fail "$file is no mesh"
    done
fi

# Nor is it a scene: a pipe without a writer would wait for ever.
mkfifo pipe.rt
ln -s /dev/zero zero.rt
for file in pipe.rt zero.rt; do
    timeout 5 "$build/step03_sphere" $file -o odd.png > out 2> err
    [ $? = 2 ] && [ "$(cat err)" = "$file: error: is a device or a pipe: expected a file" ] || fail "$file is no scene"
done

# Ctrl-C works while a scene is read: here one of 700,000 lines.
{ echo 'C 0,0,0 0,0,-1 60'; yes 'sp 0,0,-9 1 255,0,0' | head -n 700000; } > slow.rt
"$build/step03_sphere" slow.rt -o slow.png > out 2> err &
reader=$!
sleep 0.2
kill -INT $reader
(sleep 20; kill -KILL $reader) > /dev/null 2>&1 &
killer=$!
wait $reader
[ $? = 130 ] || fail "Ctrl-C while a scene is read"
kill $killer
[ ! -e slow.png ] || fail "Ctrl-C while a scene is read leaves no picture"

# A system that cannot create threads makes the same picture. (Sanitizers need more memory.)
if (ulimit -v 400000 && "$build/step03_sphere" --help) > /dev/null 2>&1; then
    (ulimit -v 400000 && "$build/step03_sphere" own.rt -o few.png --threads 1000 --quiet) 2> err ||
        fail "as many threads as there are"
    "$build/step03_sphere" own.rt -o one.png --threads 1 --quiet
    cmp -s few.png one.png || fail "fewer threads make the same picture"
fi

# 11,000 shapes: a picture, and a readable explanation.
awk 'BEGIN {
    print "C 0,0,30 0,0,-1 60"
    for (i = 0; i < 11000; ++i)
        printf "sp %d,%d,%d 0.5 %d,99,9\n", i % 20 - 10, int(i / 20) % 20 - 10, -i / 400, i % 256
}' > many.rt
"$build/step03_sphere" many.rt -o many.png --size 32x24 > out 2> err || fail "11,000 spheres"
"$build/step03_sphere" many.rt --pixel 240,320 > out 2> err
grep -q 'more shapes were missed' out || fail "a story leaves misses out"
[ "$(wc -l < out)" -lt 1000 ] || fail "a story ends"

# Control characters in names are not interpreted.
"$build/step03_sphere" "$(printf 'a\nb\033[31m.rt')" > out 2> err
[ "$(cat err)" = 'a?b?[31m.rt: error: no such file' ] || fail "a name of several lines is one line"
"$build/step03_sphere" many.rt -o "$(printf 'a\nb\033[31m.png')" --size 32x24 > out 2> err
grep -q '^a?b?\[31m\.png: ' out || fail "a picture's name of several lines is one line"

exit $failed
