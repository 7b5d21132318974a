#!/bin/sh
# shellcheck disable=SC2154  # lib.sh sets these
# A student's work is visible to git, and what can be made again is not: ignored_test.sh PROJECT_FOLDER
# Status 77 without git.
project=$1
. "$(dirname "$0")/../lib.sh"
command -v git > /dev/null || { echo "this test needs git"; exit 77; }
cd "$folder" || exit 1
cp "$project/.gitignore" .
git init -q .
seen() { git status --porcelain --untracked-files=all -- "$1" | grep -qF "$1"; }
touch_in() { mkdir -p "$(dirname "$1")" && : > "$1"; }
for file in student/sphere.cpp student/main.cpp student/tests/mine.cpp student/notes.md student/progress.txt; do
    touch_in "steps/step03_sphere/$file"
    seen "steps/step03_sphere/$file" || fail "git sees $file"
done
for file in .vscode/launch.json .vscode/tasks.json; do
    touch_in "$file"
    seen "$file" || fail "git sees $file"
done
for file in steps/step03_sphere/student_1/sphere.cpp build/course renders/a.png results/a.csv .vscode/settings.json \
    .cache/clangd/index/a.idx compile_commands.json; do
    touch_in "$file"
    ! seen "$file" || fail "git ignores $file"
done
exit $failed
