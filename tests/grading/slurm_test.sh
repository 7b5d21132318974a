#!/bin/sh
# A class, graded by Slurm: slurm_test.sh BUILD PROJECT
#
# Starts a cluster of one node on this machine and grades a class of two stages there, in four
# tasks, by the scripts that `./course grade --for slurm` writes. One task is cancelled while it
# runs, and run again alone; another is requeued. The results must equal those of a run without
# Slurm, byte for byte. It is not among the tests of a build, since it needs Debian's slurm-wlm and
# munge:
#
#     apt-get install --no-install-recommends slurm-wlm munge
#     ./course grade --help && sh tests/grading/slurm_test.sh build .
#
# All files of the cluster are in one temporary folder, and its three daemons end with this script.
set -eu
build=$(cd "$1" && pwd)
project=$(cd "$2" && pwd)
stages=step03_sphere,step05_triangle
for program in munged mungekey slurmctld slurmd sbatch; do
    PATH=$PATH:/usr/sbin:/sbin
    command -v $program > /dev/null || { echo "error: no $program: slurm-wlm and munge bring it" >&2; exit 2; }
done
. "$(dirname "$0")/../lib.sh"
chmod 755 "$folder"

is_gone() { ! kill -0 "$1" 2> /dev/null; }
end_daemon() {
    pid=$(cat "$folder/$1" 2> /dev/null) || return 0
    kill "$pid" 2> /dev/null || return 0
    until_true 10 is_gone "$pid" || kill -9 "$pid"
}
end() {
    [ ! -e "$folder/slurm.conf" ] || scancel --full --user "$(id -un)" 2> /dev/null || :
    for each in slurmd.pid slurmctld.pid munge/pid; do end_daemon $each; done
    rm -rf "$folder"
}
trap end EXIT
trap 'exit 1' INT TERM

# ---- The cluster ----
host=$(hostname -s)
me=$(id -un)
mkdir -m 700 "$folder/munge" "$folder/state" "$folder/spool"
mkdir -m 711 "$folder/temporary" # others may grade on this machine
export TMPDIR="$folder/temporary"
mungekey --create --keyfile "$folder/munge/key"
cat > "$folder/slurm.conf" << END
ClusterName=raysteps
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=${SLURM_TEST_PORT:-27817}
SlurmdPort=$((${SLURM_TEST_PORT:-27817} + 1))
SlurmUser=$me
SlurmdUser=$me
AuthType=auth/munge
AuthInfo=socket=$folder/munge/socket
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
# For a machine without systemd, control groups and a database:
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
# Two tasks of two processors at a time, for any number of processors and any requested memory:
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SlurmdParameters=config_overrides
# More often than the default of once a minute:
SchedulerParameters=sched_interval=1,bf_interval=1
KillWait=5
ReturnToService=2
NodeName=$host NodeAddr=127.0.0.1 CPUs=4 RealMemory=16000 State=UNKNOWN
PartitionName=all Nodes=$host Default=YES MaxTime=INFINITE State=UP
END
export SLURM_CONF="$folder/slurm.conf"
munged --key-file="$folder/munge/key" --socket="$folder/munge/socket" --pid-file="$folder/munge/pid" \
    --log-file="$folder/munge/log" --seed-file="$folder/munge/seed" --force 2> /dev/null
slurmctld
slurmd
is_idle() { [ "$(sinfo -h -o %T)" = idle ]; }
until_true 30 is_idle || { cat "$folder"/*.log; fail "the cluster does not start"; exit 1; }

# ---- A class: right, untouched, mistaken, broken, empty, and right in an archive ----
class=$folder/class
for student in ann bob cem dee eve gus hal ida; do mkdir -p "$class/$student"; done
for stage in $(echo $stages | tr , ' '); do
    cp "$project/steps/$stage/reference/"*.cpp "$class/ann"
    cp "$project/steps/$stage/starter/"*.cpp "$class/bob"
done
for student in cem dee gus hal ida; do cp "$class"/ann/*.cpp "$class/$student"; done
sed -i 's/if (interval.contains(far)) return far;//' "$class/cem/sphere.cpp"
echo 'int broken(' > "$class/dee/sphere.cpp"
# makes every file unique: identical files are graded once
for student in ann cem dee gus hal ida; do
    for file in "$class/$student"/*.cpp; do echo "// $student" >> "$file"; done
done
(cd "$class/hal" && cmake -E tar czf ../fay.tar.gz -- *)

"$build/grade" --for slurm "$folder/scripts"
"$build/grade" "$class" --out "$folder/local" --stages $stages > "$folder/log" 2>&1 ||
    { cat "$folder/log"; fail "graded without Slurm"; exit 1; }
mkdir "$folder/results"
cp "$folder/local/seed.txt" "$folder/results" # the same inputs

# ---- Graded by the cluster ----
submit() { # OPTION...: $job and $report are its numbers
    words=$(cd / && sh "$folder/scripts/submit.sh" "$class" "$folder/results" "$@" --parts 4)
    job=$(echo "$words" | sed -n 's/^graded by job //p')
    report=$(echo "$words" | sed -n 's/^Submitted batch job //p')
}
state() { scontrol show job "$1" | sed -n 's/^ *JobState=\([A-Z]*\).*/\1/p' | head -n 1; }
is_in() { [ "$(state "$1")" = "$2" ]; }
no_jobs() { [ -z "$(squeue -h)" ]; }
judges() { grep -qs ', seed ' "$folder/results/slurm/$1.log"; }
wait_for_all() { until_true 900 no_jobs || fail "the jobs do not end"; }

submit --stages $stages
until_true 300 judges "${job}_1" || fail "task 1 does not start: $(state "${job}_1")"
scancel "${job}_1"
wait_for_all
is_in "${job}_1" CANCELLED || fail "task 1 was not cancelled but is $(state "${job}_1")"
for task in 2 3 4; do is_in "${job}_$task" COMPLETED || fail "task $task is $(state "${job}_$task")"; done
is_in "$report" CANCELLED || fail "the reports of a part of a class: $(state "$report")"
[ ! -e "$folder/results/grades.csv" ] || fail "a grade book of a part of a class"

# The lost task alone, requeued while it runs: by default that delays it by two minutes.
submit --tasks 1 --stages $stages
until_true 300 judges "${job}_1" || fail "task 1 does not start alone: $(state "${job}_1")"
scontrol requeue "${job}_1"
until_true 60 is_in "${job}_1" PENDING || fail "task 1 was not requeued: $(state "${job}_1")"
is_over() { ! pgrep -f -- "--out $folder/results .*--part 1/4" > /dev/null; }
# otherwise it would be started twice at the same time
until_true 60 is_over || fail "what was requeued goes on"
until_true 60 scontrol update JobId="${job}_1" StartTime=now || fail "StartTime"
wait_for_all
is_in "$report" COMPLETED || fail "no reports: $(state "$report")"

tail -n 3 "$folder"/results/slurm/*.log
! ps -eo args | grep "${folder#/}/temporary/[r]aysteps-grading.*worker" || fail "processes of a task that is gone"
rm -r "$folder/results/slurm"
(cd "$folder/local" && find . -type f) | sort > "$folder/files"
(cd "$folder/results" && find . -type f) | sort | diff "$folder/files" - || fail "files (expected first)"
while read -r file; do
    cmp "$folder/local/$file" "$folder/results/$file" ||
        { diff "$folder/local/$file" "$folder/results/$file"; fail "$file is not the same"; }
done < "$folder/files"
cat "$folder/results/grades.csv"
echo "$(wc -l < "$folder/files") files are the same"
exit $failed
