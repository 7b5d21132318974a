#!/bin/sh
# Where pictures go, and where they do not: output_test.sh BUILD_FOLDER PROJECT_FOLDER
build=$1
project=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
failed=0

fail() {
    echo "FAILED: $1"
    sed 's/^/    /' out err 2> /dev/null
    failed=1
}

# picture_of SIZE FILE: whether it is a PNG of this size, "width height" in hexadecimal.
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

# -o makes its folders. The last of two counts, and of two sizes.
"$build/step03_sphere" own.rt -o a.png -o "new/très bon/a b.png" --size 1x1 --size 3x2 > out 2> err
picture_of 0000000300000002 "new/très bon/a b.png" || fail "-o makes folders"
[ ! -e a.png ] || fail "the last -o counts"
for precision in float double; do
    "$build/step03_sphere" own.rt -o $precision.png --precision $precision --size 3x2 > out 2> err
    grep -q "^$precision.png: 3 x 2 pixels, $precision, " out || fail "$precision says so"
    picture_of 0000000300000002 $precision.png || fail "$precision makes a picture"
done

# What is no place for a picture is refused, before the work and without harm.
refused "a folder" new
refused "a folder's name" other/
refused "a file for a folder" own.rt/a.png
refused "a device" /dev/null
[ -c /dev/null ] || fail "a device stays one"
ln -s own.rt linked.rt
refused "the scene itself" ./own.rt
refused "the scene by another name" linked.rt
cmp -s own.rt "$project/scenes/one_sphere.rt" || fail "the scene is as it was"

# A disk that is full, or as good as: the picture from before stays.
"$build/step03_sphere" own.rt -o old.png --size 8x6 --quiet
cp old.png kept.png
(
    trap '' XFSZ
    ulimit -f 1
    "$build/step03_sphere" own.rt -o old.png --size 640x480 2> /dev/null > /dev/null
    [ $? = 2 ]
) || fail "no room for the picture: the status is 2"
cmp -s old.png kept.png || fail "no room for the picture: the old one stays"
[ ! -e old.png.part ] || fail "no room for the picture: no part of it is left"

# A system without threads to give makes the same picture. (Sanitizers need more memory.)
if (ulimit -v 400000 && "$build/step03_sphere" --help) > /dev/null 2>&1; then
    (ulimit -v 400000 && "$build/step03_sphere" own.rt -o few.png --threads 1000 --quiet) 2> err ||
        fail "as many threads as there are"
    "$build/step03_sphere" own.rt -o one.png --threads 1 --quiet
    cmp -s few.png one.png || fail "fewer threads make the same picture"
fi

# 11,000 shapes: a picture, and a story that somebody can read to its end.
awk 'BEGIN {
    print "C 0,0,30 0,0,-1 60"
    for (i = 0; i < 11000; ++i)
        printf "sp %d,%d,%d 0.5 %d,99,9\n", i % 20 - 10, int(i / 20) % 20 - 10, -i / 400, i % 256
}' > many.rt
"$build/step03_sphere" many.rt -o many.png --size 32x24 > out 2> err || fail "11,000 spheres"
"$build/step03_sphere" many.rt --pixel 240,320 > out 2> err
grep -q 'more shapes were missed' out || fail "a story leaves misses out"
[ "$(wc -l < out)" -lt 1000 ] || fail "a story ends"

# Names are not obeyed.
"$build/step03_sphere" "$(printf 'a\nb\033[31m.rt')" > out 2> err
[ "$(cat err)" = 'a?b?[31m.rt: error: no such file' ] || fail "a name of several lines is one line"

exit $failed
