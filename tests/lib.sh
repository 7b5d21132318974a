# The common head of the shell tests, which source it: a temporary folder, removed at the end, and
# the report of failures. A test ends with `exit $failed`.
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
failed=0
RAYSTEPS_LANG=en  # whatever the language of the machine
export RAYSTEPS_LANG

# fail WHAT: reports it, with the folder's files out and err, if there are any.
fail() {
    echo "FAILED: $1"
    sed 's/^/    /' "$folder/out" "$folder/err" 2> /dev/null || true
    failed=1
}

# True if util-linux' script is there and can open a terminal: some containers have none.
has_terminal() {
    script -qec true /dev/null < /dev/null > "$folder/terminal" 2>&1
}

# copy_project PROJECT [FOLDER]: without what is built, drawn, or a student's
copy_project() {
    (cd "$1" && tar -cf - --exclude=./build --exclude=./renders --exclude=./.git \
        --exclude='./steps/*/student*' .) | tar -xf - -C "${2-$folder}"
}

# course STATUS WORDS…: runs ./course; its output is in the folder's file out, without the lines of a
# build of more than 5 seconds, on a busy machine.
course() {
    expected=$1
    shift
    ./course "$@" > "$folder/all" 2>&1
    came=$?
    grep -v '^building: \|^building …\|^configuring …\|^\[[0-9]*/[0-9]*\] ./course: ' "$folder/all" > "$folder/out"
    [ $came = "$expected" ] || fail "course $*: the status is $expected, not $came"
}

# What the folder's file out says.
says() { grep -qF -- "$1" "$folder/out" || fail "it says \"$1\""; }
says_not() { ! grep -qF -- "$1" "$folder/out" || fail "it does not say \"$1\""; }

# until_true SECONDS COMMAND…: waits for a condition; false if it is not met within that time
until_true() {
    tries=$(($1 * 20))
    shift
    until "$@" > /dev/null 2>&1; do
        tries=$((tries - 1))
        [ $tries -gt 0 ] || return 1
        sleep 0.05
    done
}

# in_french STATUS WORDS…: runs ./course in a French terminal, or in a French hand-out in any. No line has a word
# of an English sentence.
in_french() {
    for variable in RAYSTEPS_LANG LC_ALL LC_MESSAGES; do unset $variable; done
    LANG=${terminal_language-fr_FR.UTF-8}
    export LANG
    course "$@"
    RAYSTEPS_LANG=en
    export RAYSTEPS_LANG
    ! has_english "$folder/out" > "$folder/err" || fail "no English sentence: course $*"
    rm -f "$folder/err"
}

# has_english FILE: prints the lines that have a word of English sentences
has_english() {
    grep -nwiE 'about|and|are|by|cannot|came|does|has|have|is|it|its|more|not|of|than|that|the|this|to|was|with|your' "$1"
}

# french_session STAGE SOLUTION [MAIN]: from the starter to a passed check with these files.
french_session() {
    in_french 0
    in_french 0 start "$1"
    in_french 1 check "$1"
    says "Pas encore écrit"
    in_french 1 check "$1" --all
    in_french 0 hint "$1"
    in_french 2 hint "$1" 9
    files=$(echo steps/step0"$1"_*/student)
    cp "$2" "$files"
    [ $# = 2 ] || cp "$3" "$files/main.cpp"
    in_french 0 check "$1"
    says "en float et en double"
    in_french 0 run "$1"
    says " rayons"
    in_french 2 run "$1" --size
    says "erreur : --size : il manque 1 valeur"
    in_french 2 run "$1" --pixel 9999,1
    says "erreur : --pixel 9999,1 est hors de l'image"
    printf 'C 0,0,0 0,0,0 400\nsp 0,0 2\n' > "$folder/wrong.rt"
    in_french 2 run "$1" "$folder/wrong.rt"
    says "le champ de vision d'une caméra"
    says "la position d'une sphère"
}
