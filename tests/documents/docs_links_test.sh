#!/bin/sh
# Every link of a page leads to a file, and every name in backticks with a link to a header is in
# that header: docs_links_test.sh PROJECT_FOLDER. Code is left out: a lambda looks like a link. A line
# of a suite that a page names, as `check` does, is a check.
cd "$1" || exit 2

wrong=$(for page in README*.md .github/*.md common/README.md common/*/README.md tests/README.md docs/*.md docs/reference/*.md; do
    folder=$(dirname "$page")
    grep -v '^    ' "$page" | tr '\n' ' ' | grep -o ']([^)]*)' | sed 's/^](\([^#)]*\).*/\1/' | while read -r target; do
        case $target in
            '' | http:* | https:*) ;;
            *) [ -e "$folder/$target" ] || echo "$page: $target is not there" ;;
        esac
    done
    grep -v '^    ' "$page" | tr '\n' ' ' | grep -oE '\[`[A-Za-z0-9_]+`\]\([^)]*[.]hpp\)' |
        sed -E 's/..([^`]*).*\((.*)\)/\1 \2/' | while read -r name target; do
            [ ! -f "$folder/$target" ] || grep -qw "$name" "$folder/$target" ||
                echo "$page: $name is not in $target"
        done
    grep -oE 'tests/suites/[a-z0-9_/]+[.]cpp:[0-9]+' "$page" | tr ':' ' ' | while read -r suite line; do
        sed -n "${line}p" "$suite" | grep -q '^    CHECK(' || echo "$page: $suite:$line is no check"
    done
done)
[ -z "$wrong" ] || { echo "$wrong"; exit 1; }
