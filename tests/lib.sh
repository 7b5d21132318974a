# The common head of the shell tests, which source it: a temporary folder, removed at the end, and
# the report of failures. A test ends with `exit $failed`.
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
failed=0

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

# copy_project PROJECT: into the folder, without what is built, drawn, or a student's
copy_project() {
    (cd "$1" && tar -cf - --exclude=./build --exclude=./renders --exclude=./.git \
        --exclude='./steps/*/student*' .) | tar -xf - -C "$folder"
}
