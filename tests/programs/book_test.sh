#!/bin/sh
# The book, as `./course book` writes and serves it: book_test.sh BUILD_FOLDER PROJECT_FOLDER
# Needs mkdocs-material, katex, python3, curl and chromium; status 77 if one is not installed.
build=$1
project=$2
for need in katex python3 curl mkdocs; do
    command -v $need > /dev/null || { echo "the book is not tested: $need is not installed"; exit 77; }
done
browser=$(command -v chromium || command -v chromium-browser || command -v google-chrome) ||
    { echo "the book is not tested: chromium is not installed"; exit 77; }
. "$(dirname "$0")/../lib.sh"
cd "$folder" || exit 1
server=
end() {
    [ -z "$server" ] || kill "$server" 2> /dev/null
    rm -rf "$folder"
}
trap end EXIT
trap 'exit 1' HUP INT TERM

# refused WHAT EXPECTED WORDS…: one error, exit status 2, and nothing written.
refused() {
    what=$1
    expected=$2
    shift 2
    "$build/course" book "$@" > out 2> err
    [ $? = 2 ] || fail "$what: the status is 2"
    grep -qF -- "$expected" err || fail "$what: it says $expected"
    [ "$(wc -l < err)" = 1 ] && [ ! -s out ] || fail "$what: one error, and nothing else"
    [ ! -e new ] || fail "$what: nothing is written"
    [ -z "$(find . -name 'raysteps*')" ] || fail "$what: nothing is left over"
}

mkdir other
echo mine > other/notes.txt
refused "a folder of the user's" "other: error: exists already" --out other
[ "$(cat other/notes.txt)" = mine ] || fail "the user's file stays"
ln -s other link
refused "a link" "link: error: exists already" --out link
refused "a file" "other/notes.txt: error: exists already" --out other/notes.txt
refused "no name" "expected a name" --out ""
refused "no folder" "--out" --out
refused "a source that is no address" "expected an address" --out new --source main
refused "a source with a quote" "expected an address" --out new --source 'https://x.org/"'
refused "a source without a folder" "--out" --source https://example.org
refused "a word" "book" new
refused "a folder of the user's for PDFs" "exists already" --pdf other
refused "a site and PDFs" "--pdf" --out new --pdf other
(
    PATH=/nowhere
    "$build/course" book --out new 2> err
)
grep -q 'error: ' err || fail "without mkdocs it says so"

# A project of few pages and without tests, as a hand-out is: links to them are text. A page whose
# formula cannot be set is named.
mkdir -p small/common/course small/build small/docs
cp -r "$project/scenes" "$project/README.md" small
for page in README.md debugging.md cpp.md step03_sphere.md scenes.md glossary.md errata.md figures pictures gallery; do
    cp -r "$project/docs/$page" small/docs
done
cp -r "$project/common/course/book" small/common/course/book
ln -s "$project/steps" small/steps
set_pages() {
    RAYSTEPS_SOURCE=../.. PYTHONDONTWRITEBYTECODE=1 mkdocs build -q \
        -f small/common/course/book/mkdocs.yml -d "$folder/small/build/book" > out 2>&1
}
set_pages || fail "a project without tests"
grep -q 'href="../../steps/step03_sphere/sphere.hpp"' small/build/book/glossary.html || fail "links to files that are there"
grep -rql 'href="[./]*/tests/' small/build/book && fail "no link to files that are not there"
[ ! -e small/build/book/mistakes ] || fail "no known mistakes, which a hand-out does not contain"
printf '\n$\\nonsense{1}$\n' >> small/docs/scenes.md
set_pages && fail "a wrong formula"
grep -q 'docs/scenes.md: error: .*nonsense' out || fail "a wrong formula: the page is named"

# Another language is a folder of lang/, in which three sentences are translated. Without po4a the
# site is English.
cp "$project/docs/scenes.md" small/docs
mkdir small/lang small/lang/de
cp "$project/lang/pages.py" small/lang
cat > small/lang/de/book.po << 'END'
msgid ""
msgstr "Content-Type: text/plain; charset=UTF-8\n"

msgid "English"
msgstr "Deutsch"
END
PYTHONDONTWRITEBYTECODE=1 python3 small/lang/pages.py de > out || fail "a language begins"
sed '/^msgid "Scenes"/,/^msgstr/s/^msgstr ""/msgstr "Szenen"/
    /^msgid "Elements"/,/^msgstr/s/^msgstr ""/msgstr "Elemente"/
    /^msgid "Errors"/,/^msgstr/s/^msgstr ""/msgstr "Fehler"/' small/lang/de/docs/scenes.po > de.po
mv de.po small/lang/de/docs/scenes.po
set_pages || fail "a project with another language"
grep -q 'lang="de"' small/build/book/de/scenes.html || fail "pages in another language"
grep -q '<h1 id="[a-z-]*">Szenen' small/build/book/de/scenes.html || fail "a heading is translated"
grep -q 'href="de/scenes.html" hreflang="de"[^<]*' small/build/book/scenes.html || fail "a link to the other language"
grep -q 'href="../scenes.html" hreflang="en"' small/build/book/de/scenes.html || fail "and back"
[ ! -e small/build/book/de/assets ] || fail "no asset is there twice"
mkdir without_po4a
for program in mkdocs node; do ln -s "$(command -v $program)" without_po4a; done
(PATH=$PWD/without_po4a; set_pages) || fail "without po4a"
grep -q '^The pages are in English only' out || fail "without po4a it says so"
[ -e small/build/book/scenes.html ] && [ ! -e small/build/book/de ] || fail "without po4a, the English pages"

# Written, and written again over what nobody has changed.
links="https://example.org/raysteps/blob/main"
"$build/course" book --out new --source $links > out 2> err || fail "the book is written"
! grep -qv "^The figures do not run" err || fail "without a warning"
grep -q "href=\"$links/steps/step03_sphere/sphere.hpp\"" new/glossary.html || fail "links to files"
grep -q "href=\"https://example.org/raysteps/tree/main/tests/mistakes/\"" new/errata.html || fail "to folders"
known=$(cat "$project"/tests/mistakes/*.txt | grep -c '^mistake ')
[ "$(cat new/mistakes/step*.html | grep -c '<h3 ')" = "$known" ] || fail "every known mistake is shown"
grep -q "$known wrong answers" new/mistakes/index.html || fail "and counted"
grep -q 'href="mistakes/step03_sphere.html#subtracts_r_squared"' new/errata.html || fail "an erratum leads to its mistake"
echo mine > new/mine.html
cp -r new kept
"$build/course" book --out new > out 2> err && fail "a book with a file of the user's is refused"
diff -r kept new > out || fail "a book with a file of the user's stays"

# Served to this machine, with links to the project's files.
"$build/course" book > address 2> err &
server=$!
until_true 120 grep http address
address=$(head -n 1 address)
root=${address%build/book/index.html}
is() {
    got=$(curl -s -m 20 --path-as-is -o out -w '%{http_code}' "$2")
    [ "$got" = "$3" ] || fail "$1: $3, not $got"
}
is "the first page" "$address" 200
is "a file of the project" "${root}steps/step03_sphere/sphere.hpp" 200
cmp -s out "$project/steps/step03_sphere/sphere.hpp" || fail "a file of the project, as it is"
is "a folder of the project" "${root}tests/mistakes/" 200
is "no secret" "${address%%/build*}x/build/book/index.html" 403
is "a file outside" "${root}../../../../etc/passwd" 404
is "a file outside, from a folder" "${root}docs/../../../../../etc/passwd" 404
is "what is hidden" "${root}.git/config" 404
is "what is built" "${root}build/build.ninja" 404
ln -s /etc/passwd "$project/build/book/outside.txt"
ln -s ../build.ninja "$project/build/book/built.txt"
is "a link to a file outside" "${root}build/book/outside.txt" 404
is "a link to what is built" "${root}build/book/built.txt" 404
rm "$project/build/book/outside.txt" "$project/build/book/built.txt"
is "a page that is not there" "${root}build/book/none.html" 404

python3 "$project/tests/documents/book_pages.py" "$project/build/book" "$project" > out 2>&1 ||
    fail "links, anchors, formulas, alternative texts, contracts, hints, errata"
# Of the pages in another language, and of those on known mistakes, which have the same parts, two.
pages=$(cd "$project/build/book" && find . -name '*.html' ! -path './??/*' ! -path './mistakes/*' \
    -o -path './fr/index.html' -o -path './fr/step05_triangle.html' \
    -o -path './mistakes/index.html' -o -path './mistakes/step03_sphere.html' | sort)
axe=$build/axe/node_modules/axe-core/axe.min.js  # where .ci/run puts it
[ ! -e "$axe" ] || export AXE="$axe"
node "$project/tests/documents/book_browser.mjs" "$browser" "$address" $pages > out 2>&1 ||
    fail "in a browser: contrast, axe-core, a phone's width, other hosts, errors"
kill -INT "$server"
wait "$server"
[ $? = 0 ] || fail "Ctrl-C is a good end"
server=
exit $failed
