#!/bin/sh
# The container of Codespaces and VS Code has no list of packages that could differ from that of
# ./course, and a system that ./course knows: devcontainer_test.sh PROJECT_FOLDER
file=$1/.devcontainer/devcontainer.json
failed=0
fail() {
    echo "FAILED: $1"
    failed=1
}

! command -v python3 > /dev/null || sed 's#^ *//.*##' "$file" | python3 -m json.tool > /dev/null || fail "it is JSON with comments"
grep -qE '"image": "(debian:12|ubuntu:(22|24)\.04)"' "$file" || fail "Debian or Ubuntu"
command=$(sed -n 's/.*"onCreateCommand": "\(.*\)".*/\1/p' "$file")
case $command in *" && ./course run 1") ;; *) fail "./course installs its packages: $command" ;; esac
packages=$(echo "$command" | sed -n 's/.*apt-get install -y \([^&]*\) &&.*/\1/p')
[ "$packages" = git ] || fail "no other package but git: $packages"
[ -x "$1/course" ] || fail "./course can be started"
exit $failed
