#!/bin/sh
# tests/mistakes/<stage>/trace.txt: the cases that known mistakes of a stage's `trace` fail, each with
# the digest of its failures, by which `./course check` and `grade` name a mistake. A suite that does not end is stopped.
#
#     sh tests/trace_mistakes.sh write BUILD PROJECT STAGE…    after a change of a suite or a mistake
#     sh tests/trace_mistakes.sh check BUILD PROJECT STAGE…    they are current
action=$1
build=$(cd "$2" && pwd)
project=$(cd "$3" && pwd)
shift 3
. "$project/tests/lib.sh"

# The lines of one mistake's report.
lines_of() {
    sed -n -e 's/^case //; t name' -e 's/^failures //; t failures' -e d -e ':name' -e h -e d \
        -e ':failures' -e G -e 's/\n/ /p' "$1"
}

# Without the mistakes that fail in all like one with another sentence.
distinguished() {
    awk '
        /^mistake / { ++count; head[count] = $0; next }
        count == 0 { print; next }
        { failures[count] = failures[count] "\n" $0 }
        END {
            for (i = 1; i <= count; ++i) {
                sentence = substr(head[i], index(head[i], ": "))
                if (!(failures[i] in said)) said[failures[i]] = sentence
                else if (said[failures[i]] != sentence) unclear[failures[i]] = 1
            }
            for (i = 1; i <= count; ++i)
                if (failures[i] != "" && !(failures[i] in unclear) && !(failures[i] in done)) {
                    print head[i] failures[i]
                    done[failures[i]] = 1
                }
        }'
}

for stage in "$@"; do
    {
        echo "# Known mistakes of trace: the cases that each fails, and the digest of the failures in each."
        echo "# Made by tests/trace_mistakes.sh, not by hand."
        sed -n -e 's/^mistake \([a-z0-9_]*\) .*/\1/p' -e 's/^sentence: //p' \
            "$project/tests/mistakes/${stage}_trace.txt" |
            while read -r name && read -r sentence; do
                : > "$folder/report"
                RAYSTEPS_REPORT=$folder/report RAYSTEPS_ANSWER=$name \
                    timeout 300 "$build/${stage}_trace_answers_test_double" '~the picture*' > /dev/null
                echo "mistake $name: $sentence"
                lines_of "$folder/report"
            done
    } | distinguished > "$folder/$stage"
    text=$project/tests/mistakes/$stage/trace.txt
    case $action in
        write) cp "$folder/$stage" "$text" ;;
        *) diff "$text" "$folder/$stage" || fail "$stage: trace.txt is not current (above: expected first)" ;;
    esac
done
exit ${failed:-0}
