#!/bin/sh
# GitHub (CommonMark) and the site (Python-Markdown) read lists, tables and formulas of all pages in
# the same way: markdown_test.sh PROJECT_FOLDER. The rules are those in which the two differ.
cd "$1" || exit 2

# differences PAGE…: the lines that the two read differently.
differences() {
    awk '
    function wrong(what) {
        if (told != FNR) print FILENAME ":" FNR ": " what
        told = FNR
    }
    FNR == 1 { depth = told = in_block = in_fence = in_verbatim = is_text = 0 }
    {
        match($0, /^ */)
        indent = RLENGTH
        words = substr($0, indent + 1)
    }
    words == "" || words ~ /^<!--.*-->$/ { in_block = 0; next }
    {
        begins = !in_block
        in_block = 1
        number = words ~ /^[0-9]+[.)] / ? words + 0 : -1
        is_item = number >= 0 || words ~ /^[-+*] /
        if (begins) {
            if (!is_item || indent == 0) while (depth > 0 && indent <= column[depth]) {
                if (is_item && indent == column[depth]) break
                --depth
            }
            in_verbatim = indent >= 4 * (depth + 1)
        }
    }
    words ~ /^```/ { in_fence = !in_fence }
    in_fence || in_verbatim || words ~ /^```/ { next }
    words ~ /^\$\$/ && indent % 4 { wrong("a formula is indented by 4 blanks for each list that it is in") }
    begins { is_table = words ~ /^\|/; is_text = !is_item }
    words ~ /^\|/ && !is_table { wrong("a table begins after a blank line") }
    !is_item {
        if (begins && depth > 0 && indent < 4 * depth)
            wrong("in an item of a list, what follows a blank line is indented by 4 blanks")
        next
    }
    {
        if (is_text) wrong("a list begins after a blank line; no other line begins like an item")
        while (depth > 0 && indent < column[depth]) --depth
        if (depth == 0 || indent > column[depth]) {
            if (indent != 4 * depth) wrong("a list in a list is indented by 4 blanks, and no line of an item begins like another")
            column[++depth] = indent
            last[depth] = number < 0 ? -1 : 0
        }
        if ((number < 0) != (last[depth] < 0)) {
            if (!begins) wrong("an item has another mark than the one before it")
            last[depth] = number < 0 ? -1 : 0
        }
        if (number >= 0 && number != last[depth] + 1) wrong("a list is numbered from 1, by 1")
        if (words ~ /^[0-9]+\)/) wrong("a number in a list is followed by a point")
        last[depth] = number
        is_text = 0
    }' "$@"
}

folder=$(mktemp -d) || exit 2
trap 'rm -rf "$folder"' EXIT
failed=0

# differs LINE TEXT: the text is refused in this line; 0 is none.
differs() {
    printf '%b\n' "$2" > "$folder/page.md"
    lines=$(differences "$folder/page.md" | cut -d : -f 2 | tr '\n' ' ')
    [ "${lines:-0 }" = "$1 " ] || { echo "line $lines, not $1, in: $2"; failed=1; }
}
differs 0 '1. one\n2. two,\n   and more\n\n    a paragraph\n\n    $$x$$\n\n3. three\n\ntext\n\n- a\n    - b\n\n<!-- table -->\n| a | table |'
differs 2 'depth\n4. Depth 4 is enough'
differs 2 '- depth\n  4. Depth 4 is enough'
differs 2 'the sum of a\n+ b and c'
differs 2 'the list:\n- one'
differs 2 '- one\n  - within'
differs 3 '- one\n\n  a paragraph of it'
differs 3 '- one\n\n  $$x$$'
differs 3 '- one\n\n  ![a picture](a.png)'
differs 4 '- one\n\n    a paragraph of it\n- two'
differs 3 '1. one\n\n3. three'
differs 1 '2. two'
differs 1 '1) one'
differs 2 'text\n| a | table |'
differs 0 'text\n\n    - verbatim\n    4. too\n\ntext'

found=$(find README*.md docs common steps tests -name '*.md' -print | sort | while read -r page; do differences "$page"; done)
[ -z "$found" ] || { echo "$found"; failed=1; }
exit $failed
