#!/bin/sh
# The programs at the prompt: program_test.sh BUILD_FOLDER PROJECT_FOLDER
build=$1
scenes=$2/scenes
. "$(dirname "$0")/../lib.sh"
cd "$folder" || exit 1

# refused WHAT MESSAGE PROGRAM ARGUMENTS…: one error with this message, status 2, no picture.
refused() {
    what=$1
    words=$2
    shift 2
    rm -f picture.png
    case " $* " in
        *" --pixel "* | *" --rays "* | *" --requirements "*) ;;
        *) set -- "$@" -o picture.png ;;
    esac
    "$build/$@" > out 2> err
    [ $? = 2 ] || fail "$what: the status is 2"
    grep -q "error: " err && grep -qF -- "$words" err || fail "$what: says \"$words\""
    [ "$(wc -l < err)" = 1 ] || fail "$what: says it in one line"
    [ ! -s out ] || fail "$what: says nothing else"
    [ ! -e picture.png ] && [ -z "$(find . -name '*.part')" ] || fail "$what: leaves no picture"
}

holds() {
    what=$1
    shift
    "$@" || fail "$what"
}

long=$(printf '%0300d' 0 | tr 0 9)
refused "a size of 300 digits" "--size must be" step03_sphere --size "${long}x10"
refused "a size of 0" "--size must be" step03_sphere --size 0x10
refused "a size too large" "--size must be" step03_sphere --size 8193x1
refused "a negative size" "--size must be" step03_sphere --size=-1x5
refused "half a size" "--size must be" step03_sphere --size 640
refused "a pixel outside" "outside the picture" step03_sphere --pixel 480,0
refused "no pixel" "--pixel must be" step03_sphere --pixel 1;
refused "an unknown precision" '--precision: expected double, float or exact, not "half"' \
    step03_sphere --precision half
refused "a number for a word" '--gamma: expected srgb or linear, not "1"' step03_sphere --gamma 1
refused "a number in hexadecimal digits" '--threads: expected a whole number from 1 to 1024, not "0x2"' \
    step03_sphere --threads 0x2
refused "another program's precision" "build/step03_sphere_exact: ninja -C build step03_sphere_exact" step03_sphere --precision exact
refused "no threads" "threads" step03_sphere --threads 0
refused "an unknown option" "--frobnicate" step03_sphere --frobnicate
refused "two scenes" "error" step03_sphere "$scenes/one_sphere.rt" "$scenes/two_spheres.rt"
refused "a scene that is not there" "absent.rt: error:" step03_sphere absent.rt
refused "a folder for a scene" "error:" step03_sphere "$scenes"
refused "a later stage's scene" "step08_cone" step07_cylinder "$scenes/step08_cone.rt"
refused "a shade before there are shapes" "--shade" step02_camera_basis --shade normal

refused "a tolerance before there are shapes" "--tolerance" step02_camera_basis --tolerance 2
refused "a term before there is light" "--term" step08_cone --term diffuse
refused "an unknown term" "--term" step09_phong --term shiny
refused "samples before lights have a size" "--shadow-samples" step10_shadows --shadow-samples 4
refused "no samples" "--shadow-samples" step11_soft_shadows --shadow-samples 0
refused "300 digits of samples" "--shadow-samples" step11_soft_shadows --shadow-samples "$long"
refused "a negative tolerance" "--tolerance" step11_soft_shadows --tolerance=-1
refused "no tolerance" "--tolerance" step11_soft_shadows --tolerance nan
refused "300 digits of a tolerance" "--tolerance" step11_soft_shadows --tolerance "$long"
refused "no error" "--shadow-error" step11_soft_shadows --shadow-error 0
refused "no time" "--time" step03_sphere --time 0
refused "a hierarchy of one" "--hierarchy-from" step11_soft_shadows --hierarchy-from 1
refused "agreement about nothing" "--shadow-error" step11_soft_shadows --shadow-agree 8
refused "a negative depth" "--depth" step12_mirror --depth=-1
refused "a torch among lights" "--shade" step09_phong --shade torch
refused "reflections before mirrors" "bounces not in {phong,normal,depth,id,t,samples,cost}" step11_soft_shadows --shade bounces
refused "depth before there are shapes" "depth not in {torch,samples}" step02_camera_basis --shade depth
refused "a depth of several rays" "without --samples" step03_sphere --shade depth --samples 4
refused "depths with a gamma" "without --gamma" step03_sphere --shade depth --gamma srgb
refused "costs with a tolerance" "without --tolerance" step03_sphere --shade cost --tolerance 2
refused "samples that are all one" "--pixel-error" step03_sphere --shade samples
refused "a scale of names" "--shade-range" step03_sphere --shade id --shade-range 1,2
refused "a scale without numbers" "--shade-range" step03_sphere --shade-range 1,2
refused "a scale backwards" "1e-30 <= LOW < HIGH <= 1e30" step03_sphere --shade depth --shade-range 3,2
refused "a scale from nothing" "1e-30 <= LOW < HIGH <= 1e30" step03_sphere --shade depth --shade-range 0,2
refused "a scale from nearly nothing" "1e-30 <= LOW" step03_sphere --shade depth --shade-range 5e-324,1
refused "a scale without end" "1e-30 <= LOW" step03_sphere --shade depth --shade-range 1,1e308
refused "half a scale" "1e-30 <= LOW < HIGH <= 1e30" step03_sphere --shade depth --shade-range 2
refused "rays before there are shapes" "--rays" step02_camera_basis --rays 1,1
refused "rays of a pixel outside" "--rays 480,0 is outside" step03_sphere --rays 480,0
refused "rays of no pixel" "--rays must be" step03_sphere --rays 1
for other in --requirements --preview "--tolerance 2" "--time 1" "--output a.png"; do
    # shellcheck disable=SC2086
    refused "rays and $other" "${other% *}" step03_sphere --rays 1,1 $other
    # shellcheck disable=SC2086
    refused "a pixel and $other" "${other% *}" step03_sphere --pixel 1,1 $other
done
refused "requirements and a picture" "--output" step03_sphere --requirements -o a.png
refused "a light with a size" "step11_soft_shadows" step10_shadows "$scenes/step11_soft_shadows.rt"
refused "a mirror" "step12_mirror" step11_soft_shadows "$scenes/step12_mirror.rt"
refused "a mesh" "step13_meshes" step12_mirror "$scenes/step13_meshes.rt"

refused "no rays for a pixel" "--samples" step03_sphere --samples 0
refused "two and a half rays" "--samples" step03_sphere --samples 2.5
refused "300 digits of rays" "--samples" step03_sphere --samples "$long"
refused "no error of a pixel" "--pixel-error" step03_sphere --pixel-error 0
refused "errors of pixels and a time" "without --tolerance" step03_sphere --pixel-error 1 --time 1
refused "a gamma of 2.2" "--gamma" step03_sphere --gamma 2.2

printf 'C 0,0,5 0,0,-1 60\nsp 0,0,0 -2 255,0,0\n' > wrong.rt
refused "a wrong scene" "wrong.rt:2:10: error: " step03_sphere wrong.rt
printf 'C 0,0,5 0,0,-1 60\nsp 0,0,0 2 255,0,0 shiny\n' > doubtful.rt
refused "strict reading" "doubtful.rt:2:20: error: " step03_sphere doubtful.rt --strict

# A zero before a number means nothing.
"$build/step03_sphere" -o a.png --size 8x6 --samples 010 > out 2> err
grep -q ', 480 rays$' out || fail "--samples 010 is ten"

# A warning goes to the error stream, and the picture is made.
holds "a warning is no error" "$build/step03_sphere" doubtful.rt -o a.png --size 8x6 > out 2> err
grep -q 'doubtful.rt:2:20: warning: ' err || fail "a warning says where"
grep -q '^a.png: 8 x 6 pixels, double, .* s, 48 rays$' out || fail "the report has it all"

"$build/step03_sphere" doubtful.rt --quiet -o a.png --size 8x6 > out 2>&1
[ ! -s out ] || fail "--quiet says nothing"

# The same bytes on any number of threads; another precision has another text chunk.
for threads in 1 2 5; do
    "$build/step08_cone" -o $threads.png --threads $threads --quiet --size 160x120
done
cmp -s 1.png 2.png && cmp -s 1.png 5.png || fail "threads change the file"
# In stage 1, one thread is the loop of its main.cpp.
for threads in 1 2; do
    "$build/step01_ray_generation" -o $threads.png --threads $threads --quiet --size 31x17
done
cmp -s 1.png 2.png || fail "the loop of stage 1 and the program's make the same file"
"$build/step08_cone" -o f.png --precision float --size 160x120 > out
grep -q ', float, ' out || fail "--precision float is told"
grep -aq 'float' f.png || fail "the picture says its precision"

# OpenMesh, which counts the holes of meshes, is loaded for that only.
if [ -x "$build/step13_meshes" ]; then
    LD_DEBUG=files "$build/step13_meshes" -o a.png --size 8x6 --quiet 2> err
    ! grep OpenMesh err || fail "a picture does not load OpenMesh"
    "$build/step13_meshes" --requirements > out
    grep -q 'closed\|hole' out || fail "--requirements counts the holes of a mesh"
fi

# Numbers of pixels: the same file on any number of threads, and its legend in it and in the terminal.
for shade in depth id t cost "samples --pixel-error 4"; do
    for threads in 1 5; do
        "$build/step08_cone" -o $threads.png --threads $threads --size 80x60 --shade $shade > out
    done
    cmp -s 1.png 5.png || fail "threads change --shade $shade"
    grep -q "^  ${shade%% *}: " out || fail "the legend of --shade $shade"
    grep -q '^  #[0-9a-f]\{6\}  ' out || fail "the colors of --shade $shade"
    tr '\0' '\n' < 1.png | grep -aq "^${shade%% *}: " || fail "the legend of --shade $shade in its file"
done
for precision in double float; do
    "$build/step03_sphere" "$scenes/one_sphere.rt" -o a.png --shade depth --precision $precision \
        --shade-range 2,8 > out 2> err
    [ "$(grep -c '^  #.* %  ' out)" -ge 4 ] && grep -q '^  #[0-9a-f]*    0 %  2$' out &&
        grep -q '^  #[0-9a-f]*  100 %  8$' out || fail "a scale has the ends that are given"
done
# The narrowest scale, and the widest: no label is drawn over another.
for ends in 1,1.0000000000000002 1e-30,1e30; do
    timeout 10 "$build/step03_sphere" "$scenes/one_sphere.rt" -o b.png --size 8x6 --shade depth --shade-range $ends > out
    holds "the scale $ends ends" [ "$(grep -c '^  #.* %  ' out)" -le 22 ] && grep -q '100 %' out || fail "the scale $ends"
done
grep -aq -- '--shade depth --shade-range 2,8' a.png || fail "the file says its scale"

# The rays of a pixel have the numbers of its log.
"$build/step03_sphere" "$scenes/one_sphere.rt" --pixel 240,240 > out
t=$(sed -n 's/.*hit at t = //p' out)
"$build/step03_sphere" "$scenes/one_sphere.rt" --rays 240,240 > out
[ -n "$t" ] && grep -qF "hits sphere 1 at t = $t, p = (" out || fail "rays have the numbers of the log"
[ "$(wc -l < out)" = 1 ] || fail "rays are one line"

# Several rays for a pixel: as many as given, from stage 1 on, and the file contains the number.
"$build/step01_ray_generation" -o a.png --size 40x30 --samples 5 > out
grep -q ', 6000 rays$' out || fail "--samples is the number of rays for a pixel"
"$build/step03_sphere" doubtful.rt --quiet -o b.png --size 40x30 --samples 1 2> err
"$build/step03_sphere" doubtful.rt --quiet -o c.png --size 40x30 2> err
cmp -s b.png c.png || fail "--samples 1 is the default"
"$build/step03_sphere" doubtful.rt --quiet -o a.png --samples 3 --gamma srgb 2> err
grep -aq -- '--samples 3 --gamma srgb' a.png && grep -aq sRGB a.png || fail "the file says its samples"
"$build/step03_sphere" doubtful.rt --quiet -o a.png --size 40x30 --pixel-error 2.5 2> err
grep -aq -- '--samples 1024 --pixel-error 2.5' a.png || fail "the file says its error of a pixel"
"$build/step03_sphere" "$scenes/one_sphere.rt" --pixel 240,240 --samples 4 > out
grep -q 'mean of 4 other rays' out && grep -q 'hit at t = 4.0' out || fail "a log has the mean too"

# A scene is not overwritten by its own picture.
cp "$scenes/one_sphere.rt" own.rt
refused_status=0
"$build/step03_sphere" own.rt -o own.rt > out 2> err || refused_status=$?
[ $refused_status = 2 ] || fail "a picture does not overwrite its scene"
cmp -s "$scenes/one_sphere.rt" own.rt || fail "the scene is as it was"

# The explanation of a pixel has the course's symbols, and makes no picture.
"$build/step03_sphere" "$scenes/one_sphere.rt" --pixel 240,240 > out
for words in pixFinal 'tan(FOV / 2)' 'X = ' 'd_r = ' 'A, B, C' 'Δ = ' 'hit at t = 4.0' '8-bit = 214'; do
    grep -qF "$words" out || fail "the story tells $words"
done

# A reflected ray has the mirror's d and n beside it.
printf 'R 9 9\nC 0,0,0 0,0,-1 60\npl 0,0,-4 0,0,1 255,255,255 mirror:1\n' > straight.rt
"$build/step12_mirror" straight.rt --pixel 4,4 > out
grep -A4 'after 1 reflection' out | sed -n 's/^ *//; s/^[dn], .* = //p; s/^d_r = //p' | tr '\n' ';' > vectors
[ "$(cat vectors)" = "(0, 0, -1);(0, 0, 1);(0, 0, 1);" ] || fail "d, n and R: $(cat vectors)"

# The requirements of a scene, the same from every stage, and the unsupported ones; no picture.
"$build/step05_triangle" "$scenes/step12_mirror.rt" --requirements > out
for words in requires step03_sphere step09_phong 'lights* with a size' step12_mirror 'does not use'; do
    grep -q "$words" out || fail "--requirements tells $words"
done
"$build/step05_triangle" "$scenes/one_sphere.rt" --requirements > out
grep -q 'there is no mirror' out || fail "--requirements tells what is left out"
grep -q 'at risk' out && fail "no scene of scenes/ is at risk in float"

# Losses of float in a scene: sizes beside large coordinates, and gaps.
camera='A 0.2 255,255,255
C 0,0,10 0,0,-1 60'
printf '%s\nsp 0,0,0 2 9,9,9\nsp 0,0,0 2.00000002 9,9,9\n' "$camera" > gap.rt
printf '%s\nsp 3000000,0,0 2 9,9,9\n' "$camera" > far.rt
for scene in gap far; do
    "$build/step03_sphere" $scene.rt --requirements > out
    grep -q 'at risk with --precision float' out || fail "--requirements tells what float loses: $scene"
    "$build/step03_sphere" $scene.rt -o a.png --size 8x6 --precision float > out 2> err
    grep -q "$scene.rt: warning: .*--precision double" err || fail "float warns: $scene"
    "$build/step03_sphere" $scene.rt -o a.png --size 8x6 > out 2> err
    ! grep -q precision err || fail "double does not warn: $scene"
done
"$build/step03_sphere" gap.rt --requirements | grep -q 'only 1e-08 apart' || fail "how small the gap is"

# Fewer rays by --shadow-error, counted in the report, and the same bytes on any number of threads.
soft=$scenes/step11_soft_shadows.rt
rays() { sed 's/.*rays, \([0-9]*\) of them to lights with a size/\1/' out; }
"$build/step11_soft_shadows" "$soft" -o 1.png --size 80x60 --threads 1 --shadow-error 5 > out
few=$(rays)
"$build/step11_soft_shadows" "$soft" -o 2.png --size 80x60 --threads 3 --shadow-error 5 > out
[ "$few" = "$(rays)" ] && cmp -s 1.png 2.png || fail "threads change soft shadows"
"$build/step11_soft_shadows" "$soft" -o 2.png --size 80x60 --shadow-samples 1024 > out
[ "$few" -lt "$(rays)" ] || fail "--shadow-error spares rays: $few"

# The choices of --tolerance and --time are printed, and the printed options can be used.
"$build/step11_soft_shadows" "$soft" -o 1.png --size 80x60 --precision double --tolerance 4 > out
for words in depth "pixel samples" precision expected trials; do
    grep -q "^  $words  " out || fail "--tolerance tells of the $words"
done
# The same choice gives the same bytes: again, and by the equivalent options that it printed.
gap=${scenes%/scenes}/tests/measurements/accuracy/scenes/gap.rt
for scene in "$soft" "$gap"; do
    "$build/step11_soft_shadows" "$scene" -o 1.png --size 80x60 --threads 1 --tolerance 4 > out
    equivalent=$(sed -n 's/^  equivalent  *//p' out)
    [ -n "$equivalent" ] || fail "--tolerance tells equivalent options"
    "$build/step11_soft_shadows" "$scene" -o 2.png --size 80x60 $equivalent --quiet
    cmp -s 1.png 2.png || fail "--tolerance says what can be asked for: $equivalent"
    "$build/step11_soft_shadows" "$scene" -o 2.png --size 80x60 --tolerance 4 --quiet
    cmp -s 1.png 2.png || fail "--tolerance chooses the same again"
done
# A given number of rays through a pixel stays.
"$build/step11_soft_shadows" "$soft" -o 1.png --size 80x60 --tolerance 4 --samples 2 > out
grep -q "^  equivalent .* --samples 2 --shadow-samples" out || fail "--tolerance keeps --samples"
"$build/step11_soft_shadows" "$soft" -o 1.png --size 80x60 --time 0.5 > out
# On a busy machine there is no time to measure it, or the rows come too late for what was measured.
measured='^  expected .*, and 99 of 100 pixels within [0-9.]* levels\{0,1\} of '
unmeasured='^  expected .*an error that there is no time to measure'
grep -q -e "$measured" -e "$unmeasured" out || fail "--time tells the error"
"$build/step11_soft_shadows" "$soft" -o 1.png --size 80x60 --time 0.001 > out
grep -q "$unmeasured" out && ! grep -q 'pixels within' out || fail "--time tells no error that was not measured"
printf 'C 0,0,0 0,0,-1 60\npl 0,0,-5 0,0,1 255,0,0\n' > wall.rt
"$build/step04_plane" wall.rt -o 1.png --size 8x6 --shade id > out
grep -q 'plane 1, 100 % of the pixels' out || fail "--shade id tells the share of all pixels"
# A scene that only double can represent is no error where float is tried.
printf 'A 0.3 9,9,9\nC 0,0,0 0,0,-1 60\nL 0,5,0 1 255,255,255 radius:0.5\nsp 0,0,-5e-300 2e-300 9,0,0\n' > tiny.rt
for words in "--tolerance 4" "--time 0.5"; do
    holds "$words and tiny" "$build/step11_soft_shadows" tiny.rt -o 1.png --size 40x30 --quiet $words
done
# No smaller one than its trials can show.
printf 'C 0,0,5 0,0,-1 60\nL 0,9,0 0.5 255,255,255 radius:1\nsp 0,0,0 2 255,0,0\n' > lone.rt
"$build/step11_soft_shadows" lone.rt -o 1.png --size 40x30 --time 0.1 --samples 1 > out
for bound in $(sed -n 's/.*pixels within \([0-9.e+-]*\) .*/\1/p' out); do
    awk "BEGIN { exit !($bound >= 0.5) }" || fail "--time promises an error of $bound"
done
"$build/step05_triangle" "$scenes/one_sphere.rt" --tolerance 1 --quiet -o 1.png > out
[ ! -s out ] || fail "--quiet is quiet about choices"

"$build/step05_triangle" --help > out
grep -q -- '--pixel' out || fail "--help lists the options"
! LC_ALL=C.UTF-8 grep -E '^.{81}' out || fail "no line of the help is wider than 80 columns"

# Far away, and enormous: still a picture.
printf 'C 1e18,0,5 0,0,-1 60\nsp 1e18,0,0 2 255,0,0\npl 0,-1e18,0 0,1,0 9,9,9\n' > far.rt
holds "coordinates of 1e18" "$build/step04_plane" far.rt -o far.png --size 32x24 --quiet 2> err

# Ctrl-C, and other requests to end: no file, and a status above 128.
for signal in INT=130 TERM=143 HUP=129; do
    "$build/step08_cone" -o long.png --size 8192x8192 --threads 1 > out 2> err &
    process=$!
    sleep 0.3
    kill "-${signal%=*}" $process
    wait $process
    [ $? = "${signal#*=}" ] || fail "$signal"
    [ ! -e long.png ] && [ -z "$(find . -name '*.part')" ] || fail "$signal leaves no file"
done
# While the picture is written, which takes a second for one color of this size: a whole file or none.
printf 'C 0,0,5 0,0,-1 60\nsp 0,0,0 2 1,2,3\n' > one_color.rt
"$build/step03_sphere" one_color.rt -o long.png --size 8192x8192 --quiet > out 2> err &
process=$!
until [ -n "$(find . -name '*.part')" ] || ! kill -0 $process 2> /dev/null; do sleep 0.05; done
kill -TERM $process
wait $process
[ -z "$(find . -name '*.part')" ] || fail "a request to end leaves no unfinished file"
rm -f long.png

# A failure leaves no folder that was made for the picture.
"$build/step08_cone" -o made/for/.. > out 2> err && fail "a picture is no folder"
[ ! -e made ] || fail "its folders are gone"
ln -s nowhere link
"$build/step08_cone" -o link/x.png > out 2> err && fail "a link that leads nowhere is no folder"
[ -L link ] || fail "the user's link stays"

# A number is decimal.
"$build/step12_mirror" --tolerance 0x10 -o x.png > out 2> err
[ $? = 2 ] && grep -qx 'error: --tolerance must be a number from .*, not "0x10"' err || fail "0x10"

# In French: the help, the trials of --tolerance, what a scene requires, an error of a mesh file.
RAYSTEPS_SENTENCES=$scenes/../lang/fr/program.po
export RAYSTEPS_SENTENCES
printf 'C 0,0,5 0,0,-1 60\nmesh two.off 0,0,0 1 255,0,0\n' > two.rt
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n' > two.off
for options in --help "$scenes/one_sphere.rt --tolerance 9 --size 40x30 -o x.png" \
    "$scenes/step11_soft_shadows.rt --requirements" two.rt; do
    "$build/step12_mirror" $options > out 2>&1
    sed -i 's/--[a-z-]*//g' out
    ! grep -wE 'the|of|is|and|not|with|error' out || fail "$options: no English"
done
[ ! -e "$build/step13_meshes" ] || "$build/step13_meshes" two.rt -o x.png > out 2>&1
[ ! -e "$build/step13_meshes" ] || grep -q 'erreur.*le fichier finit après 2 sommets sur 3' out || fail "a mesh file"
unset RAYSTEPS_SENTENCES

exit $failed
