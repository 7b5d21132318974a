#!/bin/sh
# The workflows on GitHub: workflows_test.sh PROJECT_FOLDER
# A pull request runs all parts of .ci/run but `install`, which each job runs first; the parts that
# other workflows name exist; the version is the same in every place.
cd "$1" || exit 2
[ -d .github ] && [ -d .ci ] || { echo "this copy of the project has no workflows"; exit 77; }
failed=0
fail() { echo "FAILED: $1"; failed=1; }
parts=$(.ci/run --list | cut -d ' ' -f 1 | grep -vx install)
jobs=$(tr -d '\n' < .github/workflows/pull_request.yml | sed 's/.* part: \[\([^]]*\)].*/\1/' | tr -d ' ' | tr , '\n')
[ "$jobs" = "$parts" ] || fail "the parts of a pull request are those of .ci/run: $jobs"
for part in $(grep -h 'run: .ci/run [a-z ]*$' .github/workflows/*.yml | sed 's/.*run //'); do
    .ci/run --list | grep -q "^$part " || fail "a workflow runs the part $part, which does not exist"
done
sh .github/is_version.sh "$(sed -n 's/^project(raysteps VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)" ||
    fail "the version is the same in every place"
! sh .github/is_version.sh 0.0.0 2> /dev/null || fail "another version is refused"
! command -v python3 > /dev/null || ! python3 -c 'import yaml' 2> /dev/null ||
    python3 -c 'import sys, yaml
for file in sys.argv[1:]: yaml.safe_load(open(file))' .github/workflows/*.yml .github/ISSUE_TEMPLATE/*.yml CITATION.cff ||
    fail "each is YAML"
exit $failed
