#!/bin/sh
# The headers that steps/may_include.txt allows for a graded file of a stage are those in the stage's
# page, in the paragraph "A graded file may include …", and those for its main.cpp in "A graded
# `main.cpp` may include …"; each such header exists, and none belongs to a later stage:
# may_include_test.sh PROJECT_FOLDER
cd "$1" || exit 2
LC_ALL=C
export LC_ALL
list=steps/may_include.txt

wrong_lines() {
    grep -v '^#' $list | while read -r stage header more; do
        if [ -z "$header" ] || [ -n "$more" ]; then
            echo "$list: a stage and a header, not \"$stage $header $more\""
            continue
        fi
        from=${stage#trace:}
        [ "$from" = all ] || [ -d "steps/$from" ] || echo "$list: no stage $from"
        [ -f "$header" ] || echo "$list: no header $header"
        case $header in steps/*)
            owner=$(echo "$header" | cut -d / -f 2)
            expr "$owner" \< "$from" > /dev/null || [ "$owner/$stage" = "$from/trace:$from" ] ||
                echo "$list: $header is not of a stage before $from"
        esac
    done
}

# compare STAGE START WHOSE: the headers in the paragraph of the page that starts so, and those that
# the list has for WHOSE.
compare() {
    in_page=$(awk -v start="$2" 'index($0, start) == 1 { on = 1 } on && /^$/ { exit } on' "docs/$1.md" |
        grep -o '`[^`]*\.hpp`' | tr -d '`' | sort)
    in_list=$(awk -v whose=" $3 " 'index(whose, " " $1 " ") { print $2 }' $list | sort)
    [ "$in_page" = "$in_list" ] ||
        printf 'docs/%s.md has\n%s\n%s\n%s\n' "$1" "$in_page" "$list has for $3" "$in_list"
}

wrong_pages() {
    for folder in steps/step*/; do
        stage=$(basename "$folder")
        compare "$stage" 'A graded file may include' "all $stage"
        compare "$stage" 'A graded `main.cpp` may include' "trace:$stage"
    done
}

wrong=$(wrong_lines; wrong_pages)
[ -z "$wrong" ] || { echo "$wrong"; exit 1; }
