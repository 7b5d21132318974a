#!/bin/sh
# A hand-out, and an update to a newer one: handout_test.sh PROJECT_FOLDER
#
# Two hand-outs are built as students build them, which takes minutes: run it by hand before a hand-out
# is made; it is not a part of `./course test` nor of .ci/run.
project=$(cd "$1" && pwd)
. "$(dirname "$0")/../lib.sh"
cd "$folder" || exit 1
stage=steps/step03_sphere

# sealed FILE…: no hand-out contains a quarter of the characteristic lines of any of them: long
# lines inside of a function.
sealed() {
    for file in "$@"; do
        grep -E '^    ' "$file" | grep -E '^.{44,}' | sort -u > lines
        all=$(wc -l < lines)
        shown=$(grep -rhxF -f lines old | sort -u | wc -l)
        [ "$all" -lt 8 ] || [ $((4 * shown)) -lt "$all" ] || fail "$file is not in the hand-out"
    done
}

"$project/course" handout old > out 2>&1 || fail "a folder"
"$project/course" handout old.tar.gz > out 2>&1 || fail "an archive"
! "$project/course" handout old > out 2>&1 || fail "not over what is there"
mkdir packed
tar -xzf old.tar.gz -C packed
diff -r old packed/old > out || fail "the same in both"

[ ! -d "$project/build/book" ] || [ -e old/docs/book/step03_sphere.html ] || fail "the book goes along"

# The version is the clone's, also in a student's own repository.
commit=$(git -C "$project" rev-parse --short=7 HEAD)
cp -r old kept
(cd kept && git init -q && git add . && git -c user.name=A -c user.email=a@b.c commit -qm mine)
cd kept || exit 1
course 0 --version
says "Raysteps, version $(sed -n 's/^project(raysteps VERSION \([0-9.]*\).*/\1/p' "$project/CMakeLists.txt") ($commit), handed out on "
cd .. && rm -r kept

# Nothing shows a solution.
ls "$project"/steps/*/reference/*.cpp > /dev/null || exit 1
sealed "$project"/steps/*/reference/*.cpp "$project"/steps/*/story.cpp
grep -rlE --exclude-dir=caught_by --exclude=testing.html '^(// )?caught by: ' old > out && fail "no known mistake"
grep -rlF '#include "steps/step03_sphere/reference' old > out && fail "nothing of the reference's"
find old/steps -path '*reference/*' ! -name 'f[36][24].a' -type f > out
[ ! -s out ] || fail "archives alone"
for part in mistakes/step03_sphere.txt alternatives mutation oracle stability \
    contract grading; do
    [ ! -e "old/tests/$part" ] || fail "no tests/$part"
done
for archive in old/steps/*/reference/*/*.a old/steps/stories/*/*.a; do
    ! nm -a "$archive" 2> /dev/null | grep -q 'debug_' || fail "$archive is stripped"
    ! grep -qF "$project" "$archive" || fail "$archive does not say where it was built"
done

# A student's way through a stage.
cp -r old mine
cd mine || exit 1
course 0 start 3
course 1 check 3
says "Not written yet: intersect"
cmake --build "$project/build" --target known_mistakes > log 2>&1 || fail "known_mistakes is built"
"$project/build/known_mistakes" "$project" step03_sphere far_root_only > $stage/student/sphere.cpp
course 1 check 3
says "You try the larger root only"
says "✗ the unit sphere five ahead is hit at t = 4"
cp "$project/$stage/reference/sphere.cpp" $stage/student/sphere.cpp
rm $stage/student/main.cpp
course 0 check 3
says "the same picture as the reference's"
says "20 of 20 cases pass"
course 0 explain 3 240,320
says "Nothing differs"
course 0 test 3
says "every test passed"
course 0 hint 3
course 0
says " update"
for command in solution audit measure grade handout; do
    ! grep -q "^./course $command" "$folder/out" || fail "$command, which it lacks, is not listed"
done
course 2 solution 3
says "not part of this hand-out"
course 2 handout ../another
course 2 audit
cd ..

# A hand-out in French, with less help and a part of the stages: its pages, and in any terminal three stages, from
# the status to passed checks.
"$project/course" handout french --lang fr --stages 1-3,8 --hints 1 --without-answers > out 2>&1 || fail "in French"
for page in $(cd french && ls README.md docs/*.md steps/*/hints.md); do
    ! cmp -s "old/$page" "french/$page" || [ "$page" = docs/CHANGELOG.md ] || fail "$page is French"
done
grep -qF '<a id="the-derivation"></a>' french/docs/step03_sphere.md || fail "a French heading has the English anchor"
grep -q '<text.*pénombre' french/docs/figures/soft_shadow_regions.svg || fail "figures are French"
[ ! -e french/docs/step09_phong.md ] && [ ! -e french/steps/step09_phong/starter ] || fail "four stages"
! grep -q '^## 2' french/steps/step03_sphere/hints.md || fail "one level of hints"
! grep -q '<summary>Réponses' french/docs/step03_sphere.md || fail "no answers"
! "$project/course" handout german --lang de > out 2>&1 || fail "a language that has no pages"
says "expected a language of the pages (fr), not \"de\""
cd french || exit 1
terminal_language=C.UTF-8
for answer in step01_ray_generation_trace/one_counter step03_sphere_trace/sorted; do
    "$project/build/known_mistakes" "$project" "${answer%/*}" "${answer#*/}" > "$folder/${answer#*/}.cpp"
done
french_session 1 "$project/steps/step01_ray_generation/reference/ray_generation.cpp" "$folder/one_counter.cpp"
french_session 2 "$project/steps/step02_camera_basis/reference/camera_basis.cpp"
french_session 3 "$project/$stage/reference/sphere.cpp" "$folder/sorted.cpp"
course 0 --lang en
says "Commands:"
course 0
[ "$(grep -c '[0-9]  step[01][0-9]_' "$folder/out")" = 4 ] || fail "four lines"
course 2 start 9
says "step09_phong is not part of this hand-out"
course 0 start 8
cp "$project/steps/step08_cone/reference/cone.cpp" steps/step08_cone/student
rm steps/step08_cone/student/main.cpp
course 0 check 8
says_not "Next: "
cd ..

# An update: a reference, a page of another stage, a new file, a removed file. The manifest is a
# title and the output of cksum.
seal() {
    (cd "$1" && title=$(head -n 1 steps/handout.txt) && rm steps/handout.txt &&
        { echo "$title" && find . -type f | sed 's#^\./##' | LC_ALL=C sort | xargs cksum; } \
            > ../sums && mv ../sums steps/handout.txt)
}
cp -r old same && seal same
cmp -s old/steps/handout.txt same/steps/handout.txt || fail "anybody can make a manifest"
cp -r old new
objcopy -R .comment "new/$stage/reference/$(uname -m)/f64.a"
echo "Mended." >> new/docs/step05_triangle.md
mkdir new/docs/more
echo "More." > new/docs/more/page.md
rm new/scenes/one_sphere.rt
echo "# brighter" >> new/scenes/two_spheres.rt
seal new

cd mine || exit 1
echo "# mine" >> scenes/two_spheres.rt
echo "mine" > docs/more
cp scenes/two_spheres.rt ../two_spheres.rt
cp -r $stage/student ../student
cp -r renders ../renders
course 2 update ../nowhere
course 2 update ..
says "not a hand-out of Raysteps"
tar -czf ../docs.tar.gz docs
course 2 update ../docs.tar.gz
says "contains no hand-out of Raysteps"
head -c 9999 ../old.tar.gz > ../cut.tar.gz
course 2 update ../cut.tar.gz
cp -r ../new ../broken
echo "int broken" >> ../broken/common/geometry/ray.hpp
course 2 update ../broken
says "common/geometry/ray.hpp differs from the hand-out"
course 0 update ../new
says "changed  $stage/reference/$(uname -m)/f64.a"
says "changed  docs/step05_triangle.md"
says "new      docs/more/page.md"
says "removed  scenes/one_sphere.rt"
says "kept in scenes/two_spheres.rt.yours_1"
says "kept in docs/more.yours_1"
says "./course check 3"
for path in docs/step05_triangle.md docs/more/page.md $stage/reference/$(uname -m)/f64.a steps/handout.txt; do
    cmp -s ../new/$path $path || fail "$path is the newer one"
done
[ ! -e scenes/one_sphere.rt ] || fail "what is no more is gone"
cmp -s ../two_spheres.rt scenes/two_spheres.rt.yours_1 || fail "what was changed is kept"
diff -r ../student $stage/student > ../out || fail "a student's files stay"
diff -r ../renders renders > ../out || fail "and his pictures"
course 0 update ../new
says "nothing has changed"
course 0 check 3
course 0 update ../old.tar.gz
says "new      scenes/one_sphere.rt"

# After an interruption at any moment, it can be run again: here with 300 files to copy. The old
# files are restored each time with their times, so that nothing is built twice.
cp -r ../old ../many
find ../many -name '*.md' -o -name '*.hpp' -o -name '*.svg' | while read -r file; do
    echo >> "$file"
done
seal ../many
tar -cf ../before.tar --exclude=./build .
rm -r ../student
cp -r $stage/student ../student
halves=0
for seconds in 0 0.02 0.05 0.1 0.15 0.2 0.3 0.4; do
    build/course update ../many > ../out 2>&1 &
    until grep -q "half updated" steps/handout.txt || ! kill -0 $! 2> /dev/null; do :; done
    sleep $seconds
    kill -KILL $! 2> /dev/null
    wait $! 2> /dev/null
    grep -q "half updated" steps/handout.txt && halves=$((halves + 1))
    build/course update ../many > ../out 2>&1 || fail "once more, after $seconds s"
    diff -rq ../many . | grep -v '^Only in \.[/:]' > ../out
    [ ! -s ../out ] || fail "all is brought, after $seconds s"
    find . -name '.raysteps-*' > ../out
    [ ! -s ../out ] || fail "and nothing is left over"
    diff -r ../student $stage/student > ../out || fail "a student's files stay"
    tar -xf ../before.tar
done
[ $halves -gt 2 ] || fail "some of these were half-way: $halves"

# A half-updated project need not build: the program that started the update completes it.
echo "int broken(" >> common/course/handout/update.cpp
sed -i '1s/.*/Raysteps, half updated: run .\/course update again/' steps/handout.txt
course 2 check 3
says "an update was interrupted"
course 0 update ../old
cmp -s ../old/common/course/handout/update.cpp common/course/handout/update.cpp || fail "it is mended"
course 0 check 3

# If the references cannot be linked, the error message is about that.
cmake -S . -B other -G Ninja -DCMAKE_CXX_FLAGS=-D_GLIBCXX_USE_CXX11_ABI=0 > ../out 2>&1 &&
    fail "another library is refused"
says "This hand-out is for"
sed -i "s/defined __[a-z0-9_]*/0/" steps/fits.cpp
cmake -S . -B other2 -G Ninja > ../out 2>&1 && fail "another processor is refused"
says "This hand-out is for"
exit $failed
