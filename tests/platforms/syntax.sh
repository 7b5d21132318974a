#!/bin/sh
# Tests that macOS's compiler accepts what a student types: syntax.sh COMPILER [all]
#
# The compiler is clang++ with its libc++; `platform.sh libcxx syntax` unpacks one. Files of `course`, of the
# workers and of common/system, which use POSIX, must not use the names that only Linux has. With
# `all`, the rest is tried too: common/, the steps and the suites, in double.
compiler=$1
cd "$(dirname "$0")/../.." || exit 2
files() { git -c safe.directory="$PWD" ls-files -- "$@" ':!steps/*/student*'; }

# try FLAGS FILE…: all files are accepted
# shellcheck disable=SC2046  # a name of a file has no blank
try() {
    flags=$1
    shift
    [ $# -gt 0 ] || return 1
    printf '%s\n' "$@" | xargs -P "$(getconf _NPROCESSORS_ONLN)" -I '{}' sh -c '
        $1 -std=c++20 -I. -DGLM_FORCE_CTOR_INIT -DRAYSTEPS_ROOT=\"\" -DRAYSTEPS_BUILD=\"\" -DRAYSTEPS_VERSION=\"\" \
            -DRAYSTEPS_MESHES=1 -DRAYSTEPS_ORACLE=1 -DRAYSTEPS_STAGE=13 $2 -Wall -Wextra -Werror \
            -fsyntax-only "$3"' sh "$compiler" "$flags" '{}'
}

# The check itself: this file is refused, and only for that.
sample=$(mktemp -d) || exit 1
trap 'rm -rf "$sample"' EXIT
echo 'int main() { int ends[2]; return pipe(ends); }' > "$sample/good.cpp"
echo 'int main() { int ends[2]; return pipe2(ends, 0); }' > "$sample/bad.cpp"
poison="-include tests/platforms/no_linux.hpp"
try "$poison" "$sample/good.cpp" || exit 1
! try "$poison" "$sample/bad.cpp" 2> /dev/null || { echo "pipe2 is not refused"; exit 1; }

# Each folder's files as one, as the build compiles most of them; those with a main function alone.
failed=0
mkdir "$sample/folders"
for file in $(files 'common/course/*.cpp' 'common/system/*.cpp' 'common/contract/*.cpp' |
    grep -v '^common/course/grade'); do
    folder=$(dirname "$file" | tr / _)
    ! grep -q '^int main(' "$file" || folder=$(echo "${file%.cpp}" | tr / _)
    echo "#include \"$file\"" >> "$sample/folders/$folder.cpp"
done
try "$poison" "$sample"/folders/*.cpp \
    $(files 'tests/contract/*.cpp' | grep -vE '/(wrong|stubs/|contract_test)') || failed=1
[ "${2-}" = all ] || exit $failed
try "" $(files 'common/*.cpp' 'steps/*.cpp' 'tests/suites/*.cpp' 'tests/kit/*.cpp' |
    grep -vE '^common/(course|system|contract|mesh_file|exact)/|/exact/') || failed=1
exit $failed
