#!/bin/sh
# The meshes in a folder equal the output of the program make_meshes, byte for byte, and the program
# refuses unknown names: make_meshes_test.sh PROGRAM MESHES
. "$(dirname "$0")/../lib.sh"
program=$1

count=0
for mesh in "$2"/*.off "$2"/*.obj "$2"/*.ply "$2"/*.stl; do
    [ -e "$mesh" ] || continue
    count=$((count + 1))
    file=$(basename "$mesh")
    "$program" "${file%%.*}" "$folder/$file" > "$folder/out" 2>&1 && cmp "$mesh" "$folder/$file" ||
        fail "$mesh is what make_meshes makes of ${file%%.*}"
done
[ $count -ge 6 ] || fail "six meshes or more in $2, not $count"

"$program" --list > "$folder/out" 2>&1 || fail "make_meshes --list: status 0"
grep -qE 'sphere_1m +.*1,003,520 triangles' "$folder/out" || fail "make_meshes --list: sphere_1m"

# refuses WORD…: status 2, and an error
refuses() {
    "$program" "$@" > "$folder/out" 2> "$folder/err"
    [ $? = 2 ] && grep -q 'error: ' "$folder/err" || fail "make_meshes $*: status 2, and an error"
}
refuses
refuses unicorn "$folder/unicorn.off"
refuses cube "$folder/cube.txt"
refuses cube "$folder/no/such/folder/cube.off"

exit $failed
