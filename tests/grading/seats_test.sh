#!/bin/sh
# The worker of a graded file of functions does not contain what it should compute:
# seats_test.sh BUILD PROJECT
#
# A file can search its worker's memory, byte by byte. For each stage, the seat is searched for the
# machine code of the stage's reference, of the stories, which compute the same to explain it, and,
# before stage 13, of the hierarchy that draws meshes, which tests triangles; and for the sentences
# of the stories, by which their code could be found.
build=$(cd "$1" && pwd)
project=$(cd "$2" && pwd)
. "$(dirname "$0")/../lib.sh"

# The bytes of an object's code, as one line of hexadecimal digits.
code_of() {
    objcopy -O binary -j .text "$1" "$folder/text" && od -An -v -tx1 "$folder/text" | tr -d ' \n'
}

# The start of each function of an object: of the project's, not of those that are too short to be
# recognized, nor of what cleans up after an exception and is alike in many.
starts_of() {
    code_of "$1" > "$folder/code"
    nm -P -t d --defined-only "$1" |
        awk '$1 ~ /^_ZNK?2rt/ && $1 !~ /\.cold/ && $2 ~ /^[Tt]$/ && $4 >= 96 { print 2 * $3 + 1 }' |
        while read -r at; do cut -c "$at-$((at + 127))" "$folder/code"; done
}

# In the build's own folders: beside them, there may be a sanitized build.
objects() {
    find "$build/common" "$build/steps" -path "*$1*" \( -name '*.cpp.o' -o -name '*.cxx.o' \)
}
bvh=$(objects /raysteps_with_shapes_f64.dir/bvh/mesh_bvh)
for object in $(objects /raysteps_common_f64.dir/ | grep 'stories\|/story\|pixel_log_parts'); do
    starts_of "$object"
done > "$folder/stories"
[ "$(wc -l < "$folder/stories")" -ge 8 ] || fail "the functions of the stories are found"
sed -n 's/.*"\([^"\\]\{16,\}\)".*/\1/p' "$project"/steps/*/story.cpp > "$folder/sentences"
[ "$(wc -l < "$folder/sentences")" -ge 8 ] || fail "the sentences of the stories are found"

# Each line of options is one: of two macros, the second would have no -D.
grep -vE '^((compile|function) -|(compiler|driver|header|main_header|link|library) )' "$build"/seats/step??_*.txt > "$folder/lines" &&
    fail "seats/*.txt has options only: $(head -n 1 "$folder/lines")"

for seat in "$build"/seats/graded/step??_*.o; do
    stage=$(basename "$seat" .o)
    case $stage in *_trace) continue ;; esac
    {
        cat "$folder/stories"
        for object in $(objects "/${stage}_reference_f64.dir/"); do starts_of "$object"; done
        [ "$stage" = step13_meshes ] || starts_of "$bvh"
    } > "$folder/functions"
    code_of "$seat" > "$folder/seat"
    ! grep -qFf "$folder/functions" "$folder/seat" || fail "$stage contains code that answers it"
    ! grep -qaFf "$folder/sentences" "$seat" || fail "$stage contains sentences of the stories"
    # That the search finds what is there.
    starts_of "$bvh" > "$folder/functions"
    [ "$stage" != step13_meshes ] || grep -qFf "$folder/functions" "$folder/seat" ||
        fail "nothing is found"
done
exit $failed
