#!/bin/sh
# graded_seat.sh OUT LIST COMPILER NM OBJCOPY EXPORTED PART... -- OWN... -- CALLABLE... -- ABSENT... --
# OTHER...
#
# Everything in a stage's worker but the graded file, as one object OUT, in which that file finds
# `main` and the functions of those parts that are CALLABLE, and nothing else: every other function
# is local. Of what a queries.cpp instantiates, it finds what the object EXPORTED calls
# (common/contract/exported_queries.cpp). So a definition in the file replaces no function of the
# project. The
# functions of the objects ABSENT, which nothing calls, are at address 0: those of later stages. LIST
# contains the functions of the contracts, each marked as the stage's own (those of the objects
# OWN), callable, or another stage's.
set -eu
out=$1 list=$2 compiler=$3 nm=$4 objcopy=$5 exported=$6
shift 6
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Sorts the objects that follow into files of names: parts, own, callable, absent, other.
set -- "$@" --
for kind in parts own callable absent other; do
    : > "$work/$kind"
    while [ "$1" != -- ]; do
        echo "$1" >> "$work/$kind"
        shift
    done
    shift
done

grep -xFf "$work/callable" "$work/parts" > "$work/both"
mv "$work/both" "$work/callable"
"$nm" -u -P "$exported" | cut -d ' ' -f 1 > "$work/exported"

# The functions that the objects of a kind export. Those that a queries.cpp instantiates are weak.
# One nm for all: it loads LLVM at each start where that is installed.
functions() {
    xargs -r "$nm" -g -P --defined-only < "$work/$1" |
        awk -v exported="$work/exported" 'BEGIN { while ((getline name < exported) > 0) is_exported[name] = 1 }
            $2 == "T" || $2 == "W" && $1 in is_exported { print $1 }'
}

{ echo main; functions callable; } > "$work/kept"
functions absent | sed 's/.*/--defsym=&=0/' > "$work/defined"
"$compiler" -r -nostdlib -Wl,--force-group-allocation -Wl,@"$work/defined" -o "$work/all.o" \
    @"$work/parts"
# Symbols that the compiler made unique in the program cannot be made local, but can be renamed.
"$nm" -P "$work/all.o" | awk '$2 == "u" { print $1, "raysteps_seat_" $1 }' > "$work/renamed"
"$objcopy" --redefine-syms="$work/renamed" --keep-global-symbols="$work/kept" "$work/all.o" \
    "$work/graded.o"
for kind in own callable other; do functions $kind | sed "s/^/$kind /"; done > "$work/list"
mv "$work/list" "$list"
mv "$work/graded.o" "$out"
