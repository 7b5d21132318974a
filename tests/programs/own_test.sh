#!/bin/sh
# A ray tracer of a student's own, by docs/your_own.md: own_test.sh BUILD_FOLDER PROJECT_FOLDER
#
# It is laid out from a small project whose student has written the stages that the page needs, and
# has started one more; built with cmake alone from the page's own code; and checked, right and wrong.
build=$1
project=$2
. "$(dirname "$0")/../lib.sh"
cd "$folder" || exit 1
unset CXX CXXFLAGS CMAKE_GENERATOR

# own STATUS WORDS…: runs it; its output is in the file out.
own() {
    expected=$1
    shift
    "$build/own_course" course "$@" > out 2>&1
    came=$?
    [ $came = "$expected" ] || fail "own $*: the status is $expected, not $came"
}

mkdir -p course/steps course/renders
ln -s "$project/common" "$project/scenes" "$project/docs" course
for header in "$project"/steps/*/*.hpp "$project/steps/may_include.txt"; do
    copy=course/${header#"$project/"}
    mkdir -p "$(dirname "$copy")"
    cp "$header" "$copy"
done
own 2 mine
says "no stage is started"
[ ! -e mine ] || fail "no folder without a stage"

for stage in 01_ray_generation 02_camera_basis 03_sphere 09_phong 10_shadows; do
    cp -r "$project/steps/step$stage/reference" course/steps/step$stage/student
    echo "broken(" > course/steps/step$stage/student/main.cpp
done
cp -r "$project/steps/step05_triangle/starter" course/steps/step05_triangle/student
rm -f course/steps/step05_triangle/student/main.cpp
mkdir course/steps/step07_cylinder/student
echo "broken(" > course/steps/step07_cylinder/student/main.cpp

# What includes more than a contract leads to: it is copied, and reported. A header of the
# student's own is neither a question nor left behind.
phong=course/steps/step09_phong/student/phong.cpp
sphere=course/steps/step03_sphere/student/sphere.cpp
cp $phong right_phong.cpp
cp $sphere right_sphere.cpp
echo "// of mine" > course/steps/step09_phong/student/helpers.hpp
{
    printf '#include "helpers.hpp"\n#include "common/scene/scene.hpp"\n'
    cat right_phong.cpp
} > $phong
printf '#include "steps/step04_plane/plane.hpp"\n' >> $sphere
own 0 mine
says "steps/step09_phong/student/phong.cpp:2: warning: common/scene/scene.hpp is not a header of this stage"
says "warning: step04_plane is not started"
says_not "helpers.hpp"
[ -s mine/common/scene/primitives.hpp ] || fail "what it includes is there"
[ -s mine/steps/step09_phong/student/helpers.hpp ] || fail "the student's own header is there"
cp right_phong.cpp $phong
cp right_sphere.cpp $sphere

# An older folder, a file, a full disk: nothing changes, and nothing is left over.
ls -R mine > before
own 2 mine
says "mine: error: exists already"
ls -R mine | cmp -s - before || fail "an older folder stays as it is"
echo "a file" > taken
own 2 taken
grep -qx "a file" taken || fail "a file stays"
(
    trap '' XFSZ
    ulimit -f 0
    "$build/own_course" course full 2>&1
    echo "status $?"
) | cat > out
says "status 2"
[ ! -e full ] || fail "a full disk leaves no folder"
[ -z "$(find . -maxdepth 1 -name 'raysteps*' -o -maxdepth 1 -name '.raysteps*')" ] ||
    fail "nothing is left over"

own 2 "it's mine" "$build/step10_shadows" 60
says "cmake -G Ninja -S 'it'\\''s mine' -B 'it'\\''s mine/build'"

# An empty folder is taken. Of common/ there are values alone.
cp -r "$project/steps/step04_plane/reference" course/steps/step04_plane/student
rm -r mine
mkdir mine
own 0 mine
says "left out, as not started: step06_square, step07_cylinder, step08_cone, step11_soft_shadows, step12_mirror, step13_meshes"
says_not "warning"
ls mine/common > out
printf 'geometry\nimage\nmath\nscene\nstages\n' | cmp -s - out || fail "values alone"
find mine -name main.cpp > out
[ "$(cat out)" = mine/main.cpp ] || fail "one main.cpp"
cmp -s right_sphere.cpp mine/steps/step03_sphere/student/sphere.cpp || fail "the student's own file"
[ "$(grep -c . mine/CMakeLists.txt)" -le 14 ] || fail "a short CMakeLists.txt"

# The C++ of the page: a file for each main, with everything above it.
awk '
    function end_of_block() {
        if (first ~ /^int main/) {
            file = "page_" ++count ".cpp"
            printf "%s%s", code, block > file
            close(file)
        } else if (first !~ /^(\.\/course|cmake|~\/)/)
            code = code block "\n"
        block = first = blanks = ""
    }
    /^    / {
        sub(/^    /, "")
        if (block == "") first = $0
        block = block blanks $0 "\n"
        blanks = ""
        next
    }
    /^$/ { if (block != "") blanks = blanks "\n"; next }
    { end_of_block() }
    END { end_of_block() }' "$project/docs/your_own.md"
[ -s page_5.cpp ] && [ ! -e page_6.cpp ] || fail "five programs on the page"
for page in page_1.cpp page_2.cpp page_3.cpp page_4.cpp; do
    c++ -std=c++20 -Imine -DGLM_FORCE_CTOR_INIT -Wall -Wextra -Werror -fsyntax-only $page > out 2>&1 ||
        fail "$page of docs/your_own.md compiles"
done
cp page_5.cpp mine/main.cpp

own 2 mine "$build/step10_shadows" 60
says "mine/build/tracer: error: no such program"
says "cmake -G Ninja -S mine -B mine/build"
cmake -G Ninja -S mine -B mine/build > out 2>&1 && cmake --build mine/build >> out 2>&1 ||
    fail "plain cmake builds it"
own 0 mine "$build/step10_shadows" 60
[ "$(grep -c '^✓ ' out)" = 3 ] || fail "three pictures agree"
for scene in step03_sphere step04_plane your_own; do
    [ -s course/renders/own_$scene.png ] || fail "both pictures of $scene beside each other"
done

# The reference's pictures are drawn once.
for scene in step03_sphere step04_plane your_own; do
    "$build/step10_shadows" "$project/scenes/$scene.rt" --quiet -o $scene.rt.png
done
printf '#!/bin/sh\ncp "%s/${1##*/}.png" "$4"\n' "$folder" > drawn
chmod +x drawn

# Other programs, as shell scripts in its place: tracer STATUS SCRIPT [SECONDS]
mv mine/build/tracer right
tracer() {
    printf '#!/bin/sh\n%s\n' "$2" > mine/build/tracer
    chmod +x mine/build/tracer
    own "$1" mine "$folder/drawn" "${3-60}"
}
says_thrice() {
    [ "$(grep -cF -- "$1" out)" = 3 ] || fail "it says \"$1\" of each scene"
    [ "$(wc -l < out)" = 3 ] || fail "one line for each scene"
}

tracer 0 "cp \"$folder/\${1##*/}.png\" \"\$2\""
[ "$(grep -c ' 0 of 307200 ' out)" = 3 ] || fail "a PNG is read too"
tracer 0 "$folder/right \"\$1\" six && { echo 'P3 # text'; echo 640 480 255; tail -c 921600 six | od -An -v -tu1; } > \"\$2\""
[ "$(grep -c '^✓ ' out)" = 3 ] || fail "a P3 is read too"
tracer 1 "$folder/right \"$project/scenes/step04_plane.rt\" \"\$2\""
[ "$(grep -c '^✗ .* pixels differ by more than 4 levels; the largest difference is ' out)" = 2 ] ||
    fail "two pictures of another scene"
grep -q '^✓ step04_plane: 0 of 307200 ' out || fail "and one of this scene"
# One pixel in a thousand is 307.
tracer 0 "$folder/right \"\$1\" six && { head -c 920700 six; head -c 915 /dev/zero; } > \"\$2\""
tracer 1 "$folder/right \"\$1\" six && { head -c 920600 six; head -c 1015 /dev/zero; } > \"\$2\""
tracer 1 'kill -SEGV $$'
says_thrice "the program crashed: Segmentation fault"
tracer 1 'exit 0'
says_thrice "ended without a picture"
tracer 1 'echo "no light"; exit 3'
says_thrice "the program ended with status 3: no light"
tracer 1 'exec sleep 100' 1
says_thrice "the program did not end within 1 s"
tracer 1 'echo hello > "$2"'
says_thrice "is not a PPM"
tracer 1 'printf "P6\n640 480\n" > "$2"'
says_thrice "has no largest level"
tracer 1 'printf "P6 480 640 255\n" > "$2"'
says_thrice "has the size 480 x 640, not the scene's, 640 x 480"
tracer 1 'printf "P6 640 480 65535\n" > "$2"'
says_thrice "has the largest level 65535, not 255"
tracer 1 'printf "P6 640 480 255\n12" > "$2"'
says_thrice "has 2 bytes of colors, not 921600"
tracer 1 'printf "P3 640 480 255\n1 2 256" > "$2"'
says_thrice "has no 921600 numbers from 0 to 255"
tracer 1 'printf "\211PNG and no more" > "$2"'
says_thrice "error: "
tracer 1 'mkdir "$2"'
says_thrice "ended without a picture"
tracer 1 'yes > "$2"'
says_thrice "error: "
exit $failed
