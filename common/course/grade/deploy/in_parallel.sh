#!/bin/sh
# in_parallel.sh CLASS OUT [OPTION OF ./course grade]...: the same with GNU parallel, on this machine
# or, with its --sshloginfile, on others that share the folders.
set -eu
[ $# -ge 2 ] || { sed -n '2s/^# /usage: /p' "$0" >&2; exit 2; }
class=$1 out=$2
shift 2
sh @PROJECT@/course grade --help > /dev/null
seq 16 | parallel --quote @PROJECT@/build/grade "$class" --out "$out" --jobs 1 --part {}/16 "$@"
@PROJECT@/build/grade --report --out "$out"
