#!/bin/sh
# A fourteenth stage: extension_test.sh PROJECT
#
# A torus, which no course document has, is laid into a copy of the project: the files of stage/, and
# the changes of places.patch. Each place in the table of docs/reference/new_stage.md is left out once,
# and must be reported as the table says. The stage is drawn, audited and graded.
# shellcheck disable=SC2046,SC2154  # paths without spaces; variables of lib.sh
project=$(cd "$1" && pwd)
. "$project/tests/lib.sh"
parts=$project/tests/extension
stage=step14_torus
mkdir "$folder/copy" "$folder/left_out"
copy_project "$project" "$folder/copy"
cd "$folder/copy" || exit 2

git apply "$parts/places.patch" || exit 1
touched=$(sed -n 's|^+++ b/||p' "$parts/places.patch")
[ "$(echo "$touched" | grep -vc '^tests/')" -le 6 ] || fail "at most six files of the product are touched"
cp -R "$parts/stage/." .
for name in main starter/main; do cp steps/step13_meshes/main.cpp steps/$stage/$name.cpp; done
sed -i "s|.*/meshes.hpp\"|&\n#include \"steps/$stage/torus.hpp\"|; s|.*scene.meshes);|&\nquery.test(scene.tori);|" \
    steps/$stage/main.cpp
for halvings in 48 56 72; do
    echo "// right halvings_$halvings: that many halvings"
    sed "s/halving < 64/halving < $halvings/" steps/$stage/reference/torus.cpp
done > tests/alternatives/$stage.cpp
for place in pictures gallery; do cp docs/pictures/small/$stage.png docs/$place; done

# The page's table as lines PLACE|WHO|WHERE|WORDS.
sed -n 's/^| `\([^`]*\)` |.*| \([a-z]*\): `\([^`]*\)` |$/\1|\2||\3/p
    s/^| `\([^`]*\)` |.*| \([a-z]*\): `\([^`]*\)`: `\([^`]*\)` |$/\1|\2|\3|\4/p' \
    docs/reference/new_stage.md > "$folder/table"
for file in $touched $(cd "$parts/stage" && find . -type f ! -name '*_trace*' | cut -c 3-); do
    cut -d '|' -f 1 "$folder/table" | while read -r place; do
        case $file in "$place"*) echo found ;; esac
    done | grep -q found || fail "the table has no $file"
done
places_of() { awk -F '|' -v who="$1" '$2 == who { print $1 }' "$folder/table"; }
words_of() { awk -F '|' -v who="$1" '$2 == who { print $4 }' "$folder/table"; }

leave_out() {
    for place in "$@"; do
        saved=$folder/left_out/$place
        mkdir -p "$(dirname "$saved")"
        mv "$place" "$saved"
        case " $(echo $touched) " in
            *" $place "*) cp "$saved" "$place" && git apply -R --include="$place" "$parts/places.patch" ;;
        esac
    done
}
put_back() {
    for place in "$@"; do
        rm -f "$place"
        mv "$folder/left_out/$place" "$place"
        [ -d "$place" ] || touch "$place"
    done
}

# reported WHO COMMAND…: the command reports all places of these rows, which are left out.
reported() {
    who=$1
    shift
    "$@" > "$folder/out" 2>&1
    [ -n "$(words_of "$who")" ] || fail "the table has a place that the $who reports"
    words_of "$who" > "$folder/words"
    while read -r words; do says "$words"; done < "$folder/words"
}
build() { ninja -C build "$@"; }

# Without optimization, since it runs briefly. With a student's file, the program is linked from parts,
# as are the suites and the workers.
mkdir steps/$stage/student
cp steps/$stage/reference/torus.cpp steps/$stage/student
cmake -S . -B build -G Ninja -DCMAKE_BUILD_TYPE=None -DRAYSTEPS_REFERENCE=all > "$folder/out" 2>&1 ||
    fail "it is configured"
# Each alone: the compiler, CMake and the linker end at the first place that is missing.
each_reported() {
    while IFS='|' read -r place who where words; do
        case " $* " in *" $who "*) ;; *) continue ;; esac
        leave_out "$place"
        case $who in
            compiler) g++ -std=c++20 -I. -DGLM_FORCE_CTOR_INIT -fsyntax-only "$where" ;;
            build) cmake build ;;
            linker) build "$where" ;;
        esac > "$folder/out" 2>&1 < /dev/null
        says "$words"
        put_back "$place"
    done < "$folder/table"
}
each_reported compiler build

leave_out $(places_of program) $(places_of suite)
each_reported linker
build $stage ${stage}_trace_test_double > "$folder/out" 2>&1 || fail "it is built without its element"
reported program build/$stage
reported suite build/${stage}_trace_test_double
put_back $(places_of program) $(places_of suite)

build course $stage > "$folder/out" 2>&1 || fail "it is built"
build/$stage --quiet --size 128x96 -o docs/pictures/$stage.png > "$folder/out" 2>&1 || fail "it is drawn"
course 0 audit 14

# A right and a wrong submission.
build grade sealed ${stage}_seat ${stage}_asked_test_double ${stage}_trace_asked_test_double > "$folder/out" 2>&1 ||
    fail "the grader is built"
for student in ann ben; do
    mkdir -p "class/$student"
    cp steps/$stage/reference/torus.cpp "class/$student"
done
# Another order than the project's, whose own main.cpp is no answer.
sed '/ visit_shapes(/d; s|query.test(scene.tori);|&\nvisit_shapes(query, scene);|' steps/$stage/main.cpp \
    > class/ann/torus_main.cpp
sed -i 's|(to_closest + s) / speed|to_closest + s|' class/ben/torus.cpp
build/grade class --out results --stages 14 > "$folder/out" 2>&1 || fail "it is graded"
cat results/grades.csv > "$folder/out"
says ann,14,14,14
says ben,3,3,14

leave_out $(places_of links)
reported links sh tests/documents/docs_links_test.sh .
put_back $(places_of links)
leave_out $(places_of audit)
reported audit ./course audit 14
exit $failed
