#!/bin/sh
# Two runs give the same bytes: repeat_test.sh BUILD PROJECT
#
# Files whose compile, link or answers might differ between tools or runs, graded twice: into
# folders of different names, with temporary files elsewhere, on one thread and on several. All
# output must be the same, and contain no folder of either run.
set -eu
build=$(cd "$1" && pwd)
project=$(cd "$2" && pwd)
. "$(dirname "$0")/../lib.sh"
chmod 755 "$folder"
class=$folder/class
sphere=$project/steps/step03_sphere/reference/sphere.cpp

# submit NAME < FILE
submit() {
    mkdir -p "$class/$1"
    cat > "$class/$1/sphere.cpp"
}
submit right < "$sphere"
sed '/^Real torch/,/^}/d' "$sphere" | submit forgets_a_function
{ cat "$sphere" && echo 'asm("no_such_instruction");'; } | submit assembler
{ cat "$sphere" && echo 'static_assert(sizeof(rt::Ray) == 1);'; } | submit assertion
{ echo 'extern "C" int nowhere(int); extern "C" int neither(int);' && cat "$sphere" &&
    echo 'int (*a)(int) = nowhere; int (*b)(int) = neither;'; } | submit calls_nothing
{ cat "$sphere" && echo 'int two = 2; asm(".globl stdout\n.data\nstdout: .quad 0\n.globl environ\nenviron: .quad 0");'; } |
    submit twice
sed 's/^Real torch.*{/&\n    throw __FILE__;/; s/^Color color_from_normal.*{/&\n    throw std::runtime_error(__FILE__ __DATE__ __TIME__ __TIMESTAMP__);/
    1i #include <stdexcept>' "$sphere" | submit throws_its_name
{ echo '#include "common/no_such_header.hpp"' && cat "$sphere"; } | submit includes_nothing
{ echo '#include "common/bvh/mesh_bvh.hpp"' && cat "$sphere"; } | submit includes_too_much

# run NAME JOBS
run() {
    mkdir "$folder/$1_temporary"
    chmod 755 "$folder/$1_temporary"
    mkdir "$folder/$1"
    [ "$1" = one ] || cp "$folder/one/seed.txt" "$folder/$1"
    TMPDIR=$folder/$1_temporary "$build/grade" "$class" --out "$folder/$1" --stages 3 --jobs "$2" \
        > "$folder/log" 2>&1 || { cat "$folder/log"; fail "the grader"; }
    rmdir "$folder/$1_temporary" || fail "what $1 has left: $(ls "$folder/$1_temporary")"
}
run one 1
run another_and_longer 3
diff -r "$folder/one" "$folder/another_and_longer" || fail "the two runs"
! grep -rE "$folder|raysteps\.[A-Za-z0-9]{6}|\bcc[A-Za-z0-9]{6}\.[so]\b" "$folder/one" ||
    fail "the name of a temporary file"
refused=$(grep -l '"verdict":"refused"' "$folder"/one/students/*/*.jsonl | wc -l)
[ "$refused" -ge 6 ] || fail "$refused files are refused, of 6 and more"
echo "$(find "$folder/one" -type f | wc -l) files are the same"
exit $failed
