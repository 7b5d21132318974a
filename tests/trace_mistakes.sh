#!/bin/sh
# tests/mistakes/<stage>/trace.txt: the cases that known mistakes of a stage's `trace` fail, each with
# the digest of its failures, by which `./course check` and `grade` name a mistake.
#
#     sh tests/trace_mistakes.sh write BUILD PROJECT STAGE…    after a change of a suite or a mistake
#     sh tests/trace_mistakes.sh check BUILD PROJECT STAGE…    they are current
action=$1
build=$(cd "$2" && pwd)
project=$(cd "$3" && pwd)
shift 3
. "$project/tests/lib.sh"

# The lines of one mistake, from its source and the report of its suite.
lines_of() {
    echo "mistake $(basename "$1" .cpp): $(sed -n 's|^// sentence: ||p' "$1")"
    sed -n -e 's/^case //; t name' -e 's/^failures //; t failures' -e d -e ':name' -e h -e d \
        -e ':failures' -e G -e 's/\n/ /p' "$2"
}

# Without the mistakes that fail in all like one with another sentence.
told_apart() {
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
        for file in "$project/tests/mistakes/$stage/main"/*.cpp; do
            name=$(basename "$file" .cpp)
            RAYSTEPS_REPORT=$folder/report "$build/mistakes/mistake_${stage}_trace_${name}_double" \
                '~the picture*' > /dev/null
            lines_of "$file" "$folder/report"
        done
    } | told_apart > "$folder/$stage"
    text=$project/tests/mistakes/$stage/trace.txt
    case $action in
        write) cp "$folder/$stage" "$text" ;;
        *) diff "$text" "$folder/$stage" || fail "$stage: trace.txt is not current (above: expected first)" ;;
    esac
done
exit ${failed:-0}
