#!/bin/sh
# The headers that steps/may_include.txt allows for a graded file of a stage are those in the stage's
# page, in the paragraph "A graded file may include …"; each such header exists, and none belongs to
# a later stage: may_include_test.sh PROJECT_FOLDER
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
        [ "$stage" = all ] || [ -d "steps/$stage" ] || echo "$list: no stage $stage"
        [ -f "$header" ] || echo "$list: no header $header"
        case $header in steps/*)
            owner=$(echo "$header" | cut -d / -f 2)
            expr "$owner" \< "$stage" > /dev/null ||
                echo "$list: $header is not of a stage before $stage"
        esac
    done
}

wrong_pages() {
    for folder in steps/step*/; do
        stage=$(basename "$folder")
        in_page=$(awk '/^A graded file may include/ { on = 1 } on && /^$/ { exit } on' "docs/$stage.md" |
            grep -o '`[^`]*`' | tr -d '`' | sort)
        in_list=$(awk -v stage="$stage" '$1 == "all" || $1 == stage { print $2 }' $list | sort)
        [ "$in_page" = "$in_list" ] ||
            printf 'docs/%s.md has\n%s\n%s\n%s\n' "$stage" "$in_page" "$list has" "$in_list"
    done
}

wrong=$(wrong_lines; wrong_pages)
[ -z "$wrong" ] || { echo "$wrong"; exit 1; }
