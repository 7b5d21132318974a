#!/bin/sh
# Is this the version everywhere? is_version.sh 1.0.0
cd "$(dirname "$0")/.." || exit 2
grep -q "^project(raysteps VERSION $1 " CMakeLists.txt && grep -qx "version: $1" CITATION.cff &&
    grep -qx "## $1" docs/CHANGELOG.md && exit
echo "error: CMakeLists.txt, CITATION.cff and docs/CHANGELOG.md do not all have version $1" >&2
exit 1
