#!/bin/sh
# tests/mistakes/<stage>/trace.txt: what known mistakes of a stage's `trace` fail: of each failure, the
# digest of the question and of the wrong answer, by which `./course check` and `grade` name a mistake.
# A suite that does not end is stopped.
#
#     sh tests/trace_mistakes.sh write BUILD PROJECT STAGE…    after a change of a suite or a mistake
#     sh tests/trace_mistakes.sh check BUILD PROJECT STAGE…    they are current
action=$1
build=$(cd "$2" && pwd)
project=$(cd "$3" && pwd)
shift 3
. "$project/tests/lib.sh"

# Without the mistakes that fail in all like one with another sentence.
distinguished() {
    awk '
        /^mistake / { head[++count] = $0; next }
        count == 0 { print; next }
        { failures[count] = $0 }
        END {
            for (i = 1; i <= count; ++i) {
                sentence = substr(head[i], index(head[i], ": "))
                if (!(failures[i] in said)) said[failures[i]] = sentence
                else if (said[failures[i]] != sentence) unclear[failures[i]] = 1
            }
            for (i = 1; i <= count; ++i)
                if (failures[i] != "" && !(failures[i] in unclear) && !(failures[i] in done)) {
                    print head[i] "\n" failures[i]
                    done[failures[i]] = 1
                }
        }'
}

for stage in "$@"; do
    {
        echo "# Known mistakes of trace, each with the digests of its failures."
        echo "# Made by tests/trace_mistakes.sh, not by hand."
        sed -n -e 's/^mistake \([a-z0-9_]*\) .*/\1/p' -e 's/^sentence: //p' \
            "$project/tests/mistakes/${stage}_trace.txt" |
            while read -r name && read -r sentence; do
                : > "$folder/report"
                RAYSTEPS_REPORT=$folder/report RAYSTEPS_ANSWER=$name \
                    timeout 300 "$build/${stage}_trace_answers_test_double" '~the picture*' > /dev/null
                echo "mistake $name: $sentence"
                sed -n 's/^failures //p' "$folder/report" | tr ' ' '\n' | sort -u | tr '\n' ' ' | sed 's/ $//'
                echo
            done
    } | distinguished > "$folder/$stage"
    text=$project/tests/mistakes/$stage/trace.txt
    case $action in
        write) cp "$folder/$stage" "$text" ;;
        *) diff "$text" "$folder/$stage" || fail "$stage: trace.txt is not current (above: expected first)" ;;
    esac
done
exit ${failed:-0}
