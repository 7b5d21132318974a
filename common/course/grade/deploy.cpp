#include "common/course/grade/deploy.hpp"

#include "common/system/escaping.hpp"
#include "common/system/files.hpp"
#include "common/system/input_error.hpp"
#include "common/system/process.hpp"

#include <map>

namespace rt::grade {

namespace fs = std::filesystem;

namespace {

constexpr std::chrono::minutes time_limit{5};

constexpr const char* setup = R"sh(#!/bin/sh
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
)sh";

constexpr const char* run_autograder = R"sh(#!/bin/sh
# Gradescope runs this for each submission: the files are in submission/, and what a student reads
# comes from results/results.json, which is written whatever happens. Each has a seed of its
# own.
root=${AUTOGRADER:-/autograder}
seconds=${RAYSTEPS_SECONDS:-540}  # less than Gradescope's time limit, after which nothing is kept
answer=$root/results/results.json
results=$(mktemp -d)
why="The autograder itself failed. This does not concern your work: please inform your instructor."

finish() {
    rm -rf "$results"
    [ -s "$answer" ] || printf '{"score": 0, "output": "%s"}\n' "$why" > "$answer"
}
trap finish EXIT
grader=
trap '[ -z "$grader" ] || kill "$grader"; exit 143' HUP INT TERM
mkdir -p "$root/results"
rm -f "$answer"
timeout -k 10 "$seconds" "$root/source/raysteps/build/grade" "$root/submission" --out "$results"@STAGES@ \
    --gradescope "$answer" &
grader=$!
wait "$grader"
status=$?
[ $status = 0 ] || echo "grade ended with $status" >&2
[ $status != 124 ] || why="Your submission was not graded within $seconds s: does a loop not end?"
)sh";

constexpr const char* workflow = R"sh(# Grades the class in submissions/, in eight parts at a time.
# For .github/workflows of a private clone of the project: it has every solution. The questions are
# drawn from the secret RAYSTEPS_SEED: 16 hexadecimal digits. This makes one:
#     od -An -N8 -tx8 /dev/urandom | gh secret set RAYSTEPS_SEED
name: grade
on:
  workflow_dispatch:
env:
  PACKAGES: >-
    cmake ninja-build g++ mold catch2 libcli11-dev libglm-dev libpng-dev libopenmesh-dev
    nlohmann-json3-dev libarchive-dev libseccomp-dev libutf8proc-dev
jobs:
  grade:
    runs-on: ubuntu-24.04
    strategy:
      fail-fast: false
      matrix:
        part: [1, 2, 3, 4, 5, 6, 7, 8]
    steps:
      - uses: actions/checkout@v4
      - run: sudo apt-get update && sudo apt-get install -y --no-install-recommends $PACKAGES
      - run: |
          (umask 077 && printf '%s\n' "$SEED" > "$RUNNER_TEMP/seed")
          ./course grade submissions --out results --seed-file "$RUNNER_TEMP/seed" \
              --part ${{ matrix.part }}/8
        env:
          SEED: ${{ secrets.RAYSTEPS_SEED }}
      - uses: actions/upload-artifact@v4
        with:
          name: part-${{ matrix.part }}
          path: results
          include-hidden-files: true
  report:
    needs: grade
    runs-on: ubuntu-24.04
    steps:
      - uses: actions/checkout@v4
      - run: sudo apt-get update && sudo apt-get install -y --no-install-recommends $PACKAGES
      - uses: actions/download-artifact@v4
        with:
          pattern: part-*
          path: results
          merge-multiple: true
      - run: ./course grade --report --out results
      - uses: actions/upload-artifact@v4
        with:
          name: results
          path: results
)sh";

constexpr const char* submit = R"sh(#!/bin/sh
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
)sh";

constexpr const char* array = R"sh(#!/bin/sh
# grade.sbatch CLASS OUT PARTS [OPTION OF ./course grade]...: one part of the class, by the number of
# the task, however many tasks the array has.
#SBATCH --job-name=raysteps
#SBATCH --cpus-per-task=2
#SBATCH --mem=4G
#SBATCH --time=02:00:00
class=$1 out=$2 parts=$3
shift 3
exec @PROJECT@/build/grade "$class" --out "$out" --jobs "${SLURM_CPUS_PER_TASK:-1}" \
    --part "$SLURM_ARRAY_TASK_ID/$parts" "$@"
)sh";

constexpr const char* report = R"sh(#!/bin/sh
#SBATCH --job-name=raysteps_report
#SBATCH --mem=1G
#SBATCH --time=00:30:00
exec @PROJECT@/build/grade --report --out "$1"
)sh";

constexpr const char* in_parallel = R"sh(#!/bin/sh
# in_parallel.sh CLASS OUT [OPTION OF ./course grade]...: the same with GNU parallel, on this machine
# or, with its --sshloginfile, on others that share the folders.
set -eu
[ $# -ge 2 ] || { sed -n '2s/^# /usage: /p' "$0" >&2; exit 2; }
class=$1 out=$2
shift 2
sh @PROJECT@/course grade --help > /dev/null
seq 16 | parallel --quote @PROJECT@/build/grade "$class" --out "$out" --jobs 1 --part {}/16 "$@"
@PROJECT@/build/grade --report --out "$out"
)sh";

/// Copies the project: the files in git, or else all files but the build's output.
constexpr const char* copy_project = R"sh(
cd "$1" || exit
if git -c safe.directory="$1" ls-files --error-unmatch course > /dev/null 2>&1; then
    git -c safe.directory="$1" ls-files -z -- . ':!steps/*/student*' | tar --null -T - -cf -
else
    tar -cf - --exclude=./build --exclude=./renders --exclude=./results --exclude=./.git \
        --exclude='./steps/*/student*' .
fi | tar -xf - -C "$2"
)sh";

void replace(std::string& text, const std::string& what, const std::string& by) {
    for (std::size_t i = 0; (i = text.find(what, i)) != std::string::npos; i += by.size())
        text.replace(i, what.size(), by);
}

/// The files of one place. None of them replaces one that the lecturer has changed.
class Writer {
public:
    Writer(const fs::path& project, const std::set<int>& stages)
        : project_(shell_word(project.string())) {
        for (const int stage : stages)
            stages_ += (stages_.empty() ? " --stages " : ",") + std::to_string(stage);
    }

    void add(const fs::path& file, std::string text) {
        replace(text, "@PROJECT@", project_);
        replace(text, "@STAGES@", stages_);
        if (fs::exists(file) && (!fs::is_regular_file(file) || read_text(file) != text))
            throw InputError({file}, "exists already, with other content");
        texts_[file] = text;
    }

    void write() const {
        for (const auto& [file, text] : texts_) {
            write_text(file, text);
            if (text.rfind("#!", 0) != 0) continue;
            fs::permissions(file,
                            fs::perms::owner_exec | fs::perms::group_exec | fs::perms::others_exec,
                            fs::perm_options::add);
        }
    }

private:
    std::map<fs::path, std::string> texts_;
    std::string project_;
    std::string stages_;
};

void run(const Command& command) {
    const ProcessResult ending = run_captured(command, time_limit);
    if (ending.status != 0) throw ProgramError("error: " + command[0] + " fails\n" + ending.output);
}

void write_autograder(const fs::path& folder, const fs::path& project, Writer& writer) {
    const fs::path archive = folder / "autograder.zip";
    if (fs::exists(fs::symlink_status(archive))) throw InputError({archive}, "exists already");
    const TemporaryFolder scratch;
    const fs::path& packed = scratch.path();
    fs::create_directories(packed / "raysteps");
    run({"sh", "-c", copy_project, "copy", project.string(), (packed / "raysteps").string()});
    writer.add(packed / "setup.sh", setup);
    writer.add(packed / "run_autograder", run_autograder);
    writer.write();
    const TemporaryFolder beside(folder);  // an unfinished archive is not left
    const fs::path part = beside.path() / "autograder.zip";
    run({"cmake", "-E", "chdir", packed.string(), "cmake", "-E", "tar", "cf", part.string(),
         "--format=zip", "setup.sh", "run_autograder", "raysteps"});
    fs::rename(part, archive);
}

}  // namespace

void write_for(const std::string& place, const fs::path& place_of_files, const fs::path& project,
               const std::set<int>& stages) {
    if (place != "gradescope" && place != "github" && place != "slurm")
        throw InputError({}, "--for gradescope, github or slurm, not \"" + place + "\"");
    std::error_code error;
    fs::create_directories(place_of_files, error);
    if (error) throw InputError({place_of_files}, "cannot be made: " + error.message());
    const fs::path folder = fs::absolute(place_of_files);  // for tools that start in another folder
    Writer writer(project, stages);
    if (place == "gradescope") return write_autograder(folder, project, writer);
    if (place == "github") writer.add(folder / "grade.yml", workflow);
    if (place == "slurm") {
        writer.add(folder / "submit.sh", submit);
        writer.add(folder / "grade.sbatch", array);
        writer.add(folder / "report.sbatch", report);
        writer.add(folder / "in_parallel.sh", in_parallel);
    }
    writer.write();
}

}  // namespace rt::grade
