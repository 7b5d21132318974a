#!/bin/sh
# Gradescope runs this once, as root, when it makes the image of the autograder.
set -eu
export DEBIAN_FRONTEND=noninteractive
root=${AUTOGRADER:-/autograder}
packages="cmake ninja-build g++ mold catch2 libcli11-dev libglm-dev libpng-dev libopenmesh-dev
    nlohmann-json3-dev libarchive-dev libseccomp-dev libutf8proc-dev"
dpkg-query -W $packages > /dev/null 2>&1 || {
    apt-get update
    apt-get install -y --no-install-recommends $packages
}
# Gradescope's standard image, Ubuntu 22.04, has CMake 3.22 and g++ 11; grading is tested with newer ones.
is_new() {
    version=$(cmake --version | sed -n '1s/.*version //p')
    [ "$(printf '%s\n' 3.25 "$version" | sort -V | head -n 1)" = 3.25 ]
}
if ! is_new; then
    apt-get install -y --no-install-recommends python3-pip
    python3 -m pip install 'cmake>=3.25'
    hash -r
    is_new || { echo "CMake 3.25 or newer is needed, not $version" >&2; exit 1; }
fi
if [ "$(g++ -dumpversion | cut -d. -f1)" -lt 12 ]; then
    apt-get install -y --no-install-recommends g++-12
    export CXX=g++-12
fi
# Builds the grader, for every submission, on whichever processor that is graded.
cmake -S "$root/source/raysteps" -B "$root/source/raysteps/build" -G Ninja \
    -DRAYSTEPS_ANY_PROCESSOR=ON > /dev/null
sh "$root/source/raysteps/course" grade --help > /dev/null
