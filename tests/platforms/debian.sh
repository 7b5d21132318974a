#!/bin/sh
# shellcheck disable=SC2154  # lib.sh sets these
# The README's two commands in a bare Debian of another release, with warnings as errors, and every
# stage's picture with the bytes of this machine's:
#     sh tests/platforms/debian.sh RELEASE    as root, with debootstrap; RELEASE is trixie, say
#
# The system is in build/platforms/RELEASE, and stays there; every run takes a new copy of the project.
release=${1:?"the name of a release of Debian"}
root=$(CDPATH='' cd -- "$(dirname "$0")/../.." && pwd -P)
system=$root/build/platforms/$release
project=$system/raysteps

refuse() {
    echo "error: $1" >&2
    exit 2
}

[ "$(id -u)" = 0 ] || refuse "only root can make a system in a folder"
command -v debootstrap > /dev/null || refuse "debootstrap is missing: apt-get install debootstrap"
. "$root/tests/lib.sh"
if [ ! -e "$system.made" ]; then
    rm -rf "$system"
    mkdir -p "$system"
    debootstrap --variant=minbase "$release" "$system" > "$folder/out" 2>&1 &&
        : > "$system.made" || { fail "a bare $release is made"; exit 1; }
fi
rm -rf "$project"
mkdir "$project"
copy_project "$root" "$project"

# there COMMAND: in that system's folder of the project
there() {
    # shellcheck disable=SC2016  # the other shell's words
    unshare --mount sh -c 'mount -t proc proc "$1/proc" && mount --rbind /dev "$1/dev" &&
        exec chroot "$1" /usr/bin/env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin \
            sh -c "cd /raysteps && $2"' sh "$system" "$1" < /dev/null
}

there "apt-get -q update > /dev/null && CXXFLAGS=-Werror ./course run 1 && ./course test" ||
    fail "the README's commands"
[ -e "$root/build/build.ninja" ] || cmake -S "$root" -B "$root/build" -G Ninja > "$folder/out"
for stage in "$root"/steps/step*/; do
    stage=$(basename "$stage")
    ninja -C "$root/build" "$stage" > "$folder/out" || fail "$stage is built here"
    for precision in float double; do
        drawing="scenes/$stage.rt --size 320x240 --precision $precision --quiet -o"
        (cd "$root" && build/"$stage" $drawing "$folder/here.png") &&
            there "build/$stage $drawing there.png" && cmp "$folder/here.png" "$project/there.png" ||
            fail "the bytes of $stage, $precision"
    done
done
there "g++ --version | head -n 1"
[ $failed != 0 ] || echo "$release: passed, with the same bytes"
exit $failed
