#!/bin/sh
# shellcheck disable=SC2154  # lib.sh sets these
# A student's stage 5 with another compiler: student.sh PROJECT_FOLDER [OPTION OF CMAKE…]
#
# In a copy of the project, with the reference as the student's file: `check`, also of a file with a
# syntax error, `run`, whose picture has the bytes of the project's build, and the pictures of `view`.
project=$1
shift
. "$(dirname "$0")/../lib.sh"
stage=step05_triangle
mine=steps/$stage/student/triangle.cpp
server=
trap 'kill $server 2> /dev/null; rm -rf "$folder"' EXIT
copy_project "$project"
cd "$folder" || exit 1
mkdir "steps/$stage/student"
cp "steps/$stage/reference/triangle.cpp" $mine
mkdir build
cmake -S . -B build -G Ninja "$@" > out || { fail "it is configured"; exit 1; }

course 0 check 5
says "cases pass, in float and double"
says "the same picture as the reference's"
course 0 run 5 --size 160x120 -o mine.png
"$project/build/$stage" scenes/$stage.rt --size 160x120 -o ours.png > out
cmp mine.png ours.png || fail "the same bytes as the project's build"

./course view 5 > address 2>&1 &
server=$!
until_true 300 grep '^http' address
address=$(sed -n 's/^\(http[^ ]*\).*/\1/p' address | head -n 1)
# asked QUESTION FILE: as the page does
asked() { curl -s -f -m 300 -o "$2" "$address$1"; }
drawing="picture?stage=5&page=1&order=1&moved=0&shrink=4&precision=0&shade=0&term=0"
drawn() { asked "news?page=1&stage=5" out && asked "$drawing&whose=1" ours.png; }
until_true 300 drawn
asked "$drawing&whose=0" mine.png || fail "view draws the student's picture"
cmp mine.png ours.png || fail "view draws the reference's picture, the same"
kill -INT $server
wait $server || fail "Ctrl-C is a good end of view"
server=

printf 'int broken(\n' >> $mine
course 1 check 5
says "$mine:"
says "error: "
exit $failed
