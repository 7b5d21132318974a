#!/bin/sh
# Output on a terminal that a pipe does not get, or only in part: terminal_test.sh BUILD_FOLDER PROJECT
# Status 77 if no program can be run on a terminal.
build=$1
project=$2
. "$(dirname "$0")/../lib.sh"
has_terminal || { cat "$folder/terminal"; exit 77; }
cd "$folder" || exit 1

# seen ARGUMENTS…: the terminal's output for a picture that takes about a second.
seen() {
    script -qec "$build/step03_sphere -o a.png --size 2400x1800 --threads 1 $*" /dev/null < /dev/null
}

seen | grep -Eq ' [0-9]+ %' || fail "progress is shown on a terminal"
[ -z "$(seen --quiet)" ] || fail "--quiet says nothing on a terminal either"
"$build/step03_sphere" -o a.png --size 2400x1800 --threads 1 2> err > out
[ ! -s err ] || fail "progress is not shown in a pipe"

# Two pixels per character, no wider than the terminal.
COLUMNS=10 "$build/step03_sphere" -o a.png --preview --size 40x40 2> err > out
[ "$(grep -c '▀' out)" = 5 ] || fail "--preview draws 10 x 10 pixels in 5 lines"
[ "$(head -n 1 out | grep -o '▀' | wc -l)" = 10 ] || fail "--preview is 10 characters wide"
# A terminal's own width counts, and not a variable from before its window was resized.
on_terminal() {
    size=$1
    shift
    script -qec "stty $size && $*" /dev/null < /dev/null | tr -d '\r'
}
COLUMNS=40 on_terminal "columns 12" "$build/step03_sphere -o a.png --preview --quiet --size 40x40" > out
[ "$(grep '▀' out | head -n 1 | grep -o '▀' | wc -l)" = 12 ] || fail "--preview is as wide as the terminal"

# A build of 7 seconds tells in a pipe how far it is: first the script, then its program. A terminal
# gets nothing more. Other programs take the place of cmake and ninja.
mkdir -p fakes bare/build
printf '#!/bin/sh\nexit 0\n' > bare/build/course
printf '#!/bin/sh\necho -- Detecting\n' > fakes/cmake
cat > fakes/ninja << 'END'
#!/bin/sh
echo '[1 2 90.0] Re-running CMake...'
for i in 1 2 3 4 5 6 7; do
    case $NINJA_STATUS in
        *course*) echo "[$i/7] ./course: Building a.cpp" ;;
        *) echo "[$i 7 9$i.0] Building CXX object a.cpp.o" ;;
    esac
    sleep 1
done
END
chmod +x bare/build/course fakes/*
cp "$project/course" bare
PATH=$PWD/fakes:$PATH bare/course 2> err
[ "$(grep -c '^configuring ' err) $(wc -l < err)" = "1 2" ] || fail "the script has one line more in 7 s"
grep -q '^\[[1-7]/7\] ./course: Building a.cpp$' err || fail "the line contains the share and the file"
if [ -x "$build/course" ]; then
    PATH=$PWD/fakes:$PATH "$build/course" run 3 --quiet -o a.png --size 4x3 2> err
    grep -Eq '^building: +[0-9]+ %, [0-9] s left: a.cpp$' err || fail "its program has a line, too, without CMake's time"
    [ "$(wc -l < err)" = 1 ] || fail "but only one in 7 s"
    PATH=$PWD/fakes:$PATH script -qec "$build/course run 3 --quiet -o a.png --size 4x3" /dev/null < /dev/null > out
    [ "$(wc -l < out)" = 0 ] || fail "a terminal has one line, which is erased"

    # The state fits on a small terminal, with what to do next at its end; nothing is wider.
    escape=$(printf '\033')
    for size in "80 24" "50 24"; do
        on_terminal "columns ${size% *} rows ${size#* }" "$build/course" | sed "s/$escape\[[0-9]*m//g" > out
        [ "$(wc -l < out)" -lt 24 ] || fail "$size: the stages and what is next fit in 24 rows"
        tail -n 2 out | grep -q '^Next: ./course ' || fail "$size: what is next comes last"
        ! LC_ALL=C.UTF-8 grep -E "^.{$((${size% *} + 1))}" out || fail "$size: no line is wider"
    done
    on_terminal "columns 80 rows 24" "$build/course --help" > out
    ! LC_ALL=C.UTF-8 grep -E '^.{81}' out || fail "no line of the help is wider"
    says "./course grade"
    "$build/course" --help > out
    ! LC_ALL=C.UTF-8 grep -E '^.{81}' out || fail "no line of the help is wider in a pipe"

    # Colors: on a terminal that has some, or if they are asked for.
    colored() { grep -q "$escape" out; }
    on_terminal "columns 80" "env TERM=xterm $build/course" > out
    colored || fail "a terminal has colors"
    on_terminal "columns 80" "env TERM=dumb $build/course" > out
    ! colored || fail "a terminal without colors has none"
    on_terminal "columns 80" "env TERM=xterm NO_COLOR=1 $build/course" > out
    ! colored || fail "NO_COLOR is respected"
    "$build/course" > out
    ! colored || fail "a pipe has no colors"
    CLICOLOR_FORCE=1 "$build/course" > out
    colored || fail "CLICOLOR_FORCE is respected"
fi

# Words that a program does not know, in their order, with the option that is meant.
"$build/step03_sphere" --tolerence 3 --qiet 2> out && fail "an unknown option is refused"
says "not expected: --tolerence --qiet"
says "Did you mean --tolerance?"
"$build/step03_sphere" --version > out
grep -Eq '^step03_sphere, Raysteps [0-9]+\.[0-9]+\.[0-9]+' out || fail "the version"

exit $failed
