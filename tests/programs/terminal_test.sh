#!/bin/sh
# Output on a terminal that a pipe does not get: terminal_test.sh BUILD_FOLDER
# Needs util-linux' script, which runs a program on a terminal; status 77 if it is not installed.
build=$1
script --version 2> /dev/null | grep -q util-linux || exit 77
. "$(dirname "$0")/../lib.sh"
cd "$folder" || exit 1

# seen ARGUMENTS…: the terminal's output for a picture that takes about a second.
seen() {
    script -qec "$build/step03_sphere -o a.png --size 2400x1800 --threads 1 $*" /dev/null < /dev/null
}

seen | grep -Eq ' [0-9]+ %, [0-9]+ s left' || fail "progress is shown on a terminal"
[ -z "$(seen --quiet)" ] || fail "--quiet says nothing on a terminal either"
"$build/step03_sphere" -o a.png --size 2400x1800 --threads 1 2> err > out
[ ! -s err ] || fail "progress is not shown in a pipe"

# Two pixels per character, no wider than the terminal.
COLUMNS=10 "$build/step03_sphere" -o a.png --preview --size 40x40 2> err > out
[ "$(grep -c '▀' out)" = 5 ] || fail "--preview draws 10 x 10 pixels in 5 lines"
[ "$(head -n 1 out | grep -o '▀' | wc -l)" = 10 ] || fail "--preview is 10 characters wide"

exit $failed
