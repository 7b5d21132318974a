#!/bin/sh
# submit.sh CLASS OUT [--parts N] [--tasks LIST] [OPTION OF ./course grade]...
#
# Grades a class with Slurm, in N parts (16), each of them a task of an array, and writes the reports
# when all have ended well. The project, CLASS and OUT are in folders that all nodes share; the tasks'
# logs are in OUT/slurm. Interrupted, or a node lost: the same command goes on. --tasks 2,7 runs these
# parts alone, of the same N.
set -eu
here=$(CDPATH='' cd -- "$(dirname "$0")" && pwd)
[ $# -ge 2 ] || { sed -n '2s/^# /usage: /p' "$0" >&2; exit 2; }
class=$(CDPATH='' cd -- "$1" && pwd)
out=$2
shift 2
parts=16
tasks=
left=$#  # the words not read yet; those of ./course grade go behind them
while [ $left -gt 0 ]; do
    case $1 in
        --parts | --tasks)
            [ $left -gt 1 ] || { echo "error: $1 needs a value" >&2; exit 2; }
            if [ "$1" = --parts ]; then parts=$2; else tasks=$2; fi
            shift
            left=$((left - 1))
            ;;
        *) set -- "$@" "$1" ;;
    esac
    shift
    left=$((left - 1))
done
case $parts in
    '' | *[!0-9]* | 0*) echo "error: --parts needs a number from 1 on, not \"$parts\"" >&2; exit 2 ;;
esac
mkdir -p "$out/slurm"
out=$(CDPATH='' cd -- "$out" && pwd)
# Built once, before many tasks use it. For nodes whose processors differ, see docs/reference/grading.md.
sh @PROJECT@/course grade --help > /dev/null
job=$(sbatch --parsable --array="${tasks:-1-$parts}" --output="$out/slurm/%A_%a.log" \
    "$here/grade.sbatch" "$class" "$out" "$parts" "$@")
echo "graded by job ${job%%;*}"
sbatch --kill-on-invalid-dep=yes --dependency="afterok:${job%%;*}" \
    --output="$out/slurm/%j_reports.log" "$here/report.sbatch" "$out"
