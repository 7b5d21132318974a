#!/bin/sh
# The page of `./course view` in Chromium: view_test.sh BUILD_FOLDER PROJECT_FOLDER
# Needs chromium, driven through its own DevTools pipe, and curl; status 77 if they are not
# installed.
build=$1
project=$2
browser=$(command -v chromium || command -v chromium-browser || command -v google-chrome) || exit 77
command -v curl > /dev/null || exit 77
. "$(dirname "$0")/../lib.sh"
cd "$folder" || exit 1
server=
chromium=

end() {
    exec 8>&- 9<&-
    for process in $server $chromium; do kill "$process" 2> /dev/null; done
    wait 2> /dev/null
    rm -rf "$folder"
}
trap end EXIT
trap 'exit 1' HUP INT TERM

# A small project: a student has started stage 5, and shows normals in place of colors.
mkdir -p project/common/course project/steps/step05_triangle/student built temporary
ln -s "$project/scenes" project/scenes
cp -r "$project/common/course/view" project/common/course/view
head -c 8000000 /dev/zero | tr '\0' / >> project/common/course/view/difference.js  # a comment
touch project/steps/step05_triangle/student/triangle.cpp
program() {
    printf '#!/bin/sh\nexec "%s/step05_triangle" "$@" %s\n' "$build" "$2" > built/new
    chmod +x built/new
    mv built/new "built/$1"
}
program step05_triangle "--shade normal"
program step05_triangle_reference_program

# script COMMANDS: makes these the student's program.
script() {
    printf '#!/bin/sh\n%s\n' "$1" > built/new
    chmod +x built/new
    mv built/new built/step05_triangle
}

TMPDIR=$folder/temporary "$build/view_server" project built 5 > address &
server=$!
until_true 5 grep http address
address=$(head -n 1 address)
origin=${address%/*/}
port=${origin##*:}

# Programs are built for the page before anything is started, too.
mkdir -p empty/steps
ln -s "$project/scenes" empty/scenes
echo "the compiler's words" > empty/compiler_says
"$build/view_server" empty built 5 > nothing_started &
other=$!
until_true 5 grep http nothing_started
built_for_nobody() {
    curl -s -m 20 "$(head -n 1 nothing_started)news?page=1&stage=5" | grep "the compiler's words"
}
until_true 10 built_for_nobody || fail "programs are built with nothing started"
kill -INT $other
wait $other

# ---- access control

# status WORDS…: the status that curl gets.
status() {
    curl -s -m 20 -o out -w '%{http_code}' "$@"
}

answers() {
    [ "$(status "${address}stages")" = 200 ] || fail "it still answers after $1"
}

is() {
    what=$1
    expected=$2
    shift 2
    got=$(status "$@")
    [ "$got" = "$expected" ] || fail "$what: $expected, not $got"
}

drawing="stage=5&page=1&order=1&moved=0&shrink=4&precision=0&shade=0&term=0"
is "the page" 200 "$address"
is "the page by the name localhost" 200 "http://localhost:$port/${address#"$origin/"}"
is "no token" 403 "$origin/"
is "a wrong token" 403 "$origin/0123456789abcdef0123456789abcdef/"
is "another host's name" 403 -H "Host: example.org:$port" "$address"
is "a host without the port" 403 -H "Host: localhost" "$address"
is "no host" 400 -H "Host:" "$address"
is "a post" 405 -d x "$address"
is "a file" 404 --path-as-is "$address../../../etc/passwd"
is "a picture" 200 "${address}picture?$drawing&whose=0"
[ "$(head -c 4 out | tail -c 3)" = PNG ] || fail "a picture is a PNG"
is "a stage of words" 400 "${address}picture?stage=../5&whose=0"
is "no 99th stage" 400 "${address}picture?stage=99&shrink=1&whose=0"
is "a size of nothing" 400 "${address}picture?$drawing&whose=0&shrink=0"
is "a camera at no place" 400 \
    "${address}picture?$drawing&whose=0&moved=1&x=nan&y=0&z=0&yaw=0&pitch=0&fov=60"
is "a pixel with a shell in it" 400 "${address}story?$drawing&row=1;id&column=2"
is "a pixel outside" 200 "${address}story?$drawing&row=8000&column=2"
grep -q 'is outside the picture' out || fail "a pixel outside is told"
curl -s "$address" -D headers -o out
grep -qi '^access-control' headers && fail "other pages may not read it"
grep -Eiq '<style|<script>|[[:space:]](style|on[a-z]+)=|javascript:' out &&
    fail "the page has no style and no script but those of its other files"
grep -qi '^content-security-policy:.*default-src .none.' headers || fail "a policy for the page"
grep -qi '^content-security-policy:.*unsafe' headers && fail "a policy without unsafe sources"
is "the page's style" 200 "${address}page.css"
is "the page's script" 200 "${address}page.js"
is "the style without the token" 403 "$origin/page.css"
is "another file of the viewer" 404 "${address}view.cpp"
ss -ltn 2> /dev/null | grep ":$port " | grep -vq '127\.0\.0\.1' && fail "it listens to this machine"

is "a long address" 431 "$address?$(printf '%020000d' 0)"
is "a long header" 431 -H "X: $(printf '%050000d' 0)" "$address"
answers "what is too long"
head -c 100000 /dev/urandom | curl -s -m 5 "telnet://127.0.0.1:$port" > out 2>&1
answers "garbage"
python3 "$project/tests/programs/server_attacks.py" "$address" > out 2>&1 ||
    fail "requests that no browser sends"

# What a program leaves running ends with it, and its picture does not wait for that.
script 'sleep 301 & echo $! > left; exit 3'
is "a program that leaves another" 422 "${address}picture?$drawing&whose=0"
left_ends() { ! ps -o stat= -p "$(cat left)" | grep -v Z; }
until_true 5 left_ends || fail "what a program leaves ends with it"
program step05_triangle "--shade normal"

# A newer picture ends the older one, and its program, also if the older's request arrives last.
endless='echo $$ > endless; sleep 301 & wait'
began() {
    until_true 10 [ -s endless ]
}
script "$endless"
curl -s -m 20 -o older_picture -w '%{http_code}' "${address}picture?$drawing&whose=0&order=2" > older &
older=$!
began || fail "a program without end is run"
is "a request that was overtaken" 409 "${address}picture?$drawing&whose=0"
kill -0 "$(cat endless)" 2> /dev/null || fail "a request that was overtaken ends no program"
is "a program that is not there" 500 "${address}picture?$drawing&whose=0&order=3&stage=6"
wait $older
[ "$(cat older)" = 409 ] || fail "a newer picture ends the older"
kill -0 "$(cat endless)" 2> /dev/null && fail "a newer picture ends the older's program"
rm endless
program step05_triangle "--shade normal"

# ---- what the page shows

mkfifo to from
"$browser" --headless --no-sandbox --disable-gpu --disable-dev-shm-usage --window-size=1280,800 \
    --user-data-dir="$folder/profile" --remote-debugging-pipe \
    3<> to 4<> from 2> chromium_log > /dev/null &
chromium=$!
exec 8<> to 9<> from
stdbuf -o0 tr '\0' '\n' <&9 > answers &
chromium="$chromium $!"
question=0

# ask METHOD PARAMETERS: the answer of DevTools, in $answer.
ask() {
    question=$((question + 1))
    printf '{"id":%d,"method":"%s",%s"params":{%s}}\0' $question "$1" "$session" "$2" >&8
    tries=0
    until answer=$(grep -m 1 "^{\"id\":$question," answers); do
        [ $((tries += 1)) -lt 400 ] || { fail "$1 is not answered"; exit 1; }
        sleep 0.05
    done
}

# value SCRIPT: its value, as text, in $value. No double quotes in it.
value() {
    ask Runtime.evaluate "\"expression\":\"String($(echo "$1" | tr '\n' ' '))\""
    value=$(printf '%s' "$answer" | sed 's/.*"value":"\([^"]*\)".*/\1/')
}

# shows WHAT SCRIPT: becomes true before long.
shows() {
    waits=0
    until value "$2" && [ "$value" = true ]; do
        [ $((waits += 1)) -lt 100 ] || { fail "$1: $value"; return; }
        sleep 0.1
    done
}

session=
ask Target.createTarget "\"url\":\"$address\""
target=$(printf '%s' "$answer" | sed 's/.*"targetId":"\([^"]*\)".*/\1/')
ask Target.attachToTarget "\"targetId\":\"$target\",\"flatten\":true"
session=$(printf '%s' "$answer" | sed 's/.*"sessionId":"\([^"]*\)".*/"sessionId":"\1",/')

caption="document.querySelector('[data-of=difference] figcaption').textContent"
shows "both pictures, whole" \
    "['mine', 'reference'].every(id => document.getElementById(id).width === 640)"
shows "where they differ" "/^[0-9]+ of 307200 pixels differ/.test($caption)"
shows "all stages, one of them started" "document.getElementsByName('stage').length === $(ls -d "$project"/steps/step*/ | wc -l) &&
    document.querySelectorAll('.started').length === 1 && document.title === '5 · triangle'"
shows "a picture that is not black" "images.mine.data.some((v, i) => v > 0 && i % 4 < 3)"

shows "the style of page.css" \
    "getComputedStyle(document.getElementById('pictures')).display === 'grid'"
# Text in the page never becomes a script or a style of it.
value "document.body.append(
    Object.assign(document.createElement('script'), {textContent: 'window.inlineRan = 1'}),
    Object.assign(document.createElement('style'), {textContent: 'h1 { opacity: 0 }'}))"
shows "no inline script and no inline style" "window.inlineRan === undefined &&
    getComputedStyle(document.querySelector('h1')).opacity === '1'"

# A slider, by the keyboard: another picture, of the scene from the new camera.
sum="images.reference.data.reduce((a, v) => (a * 31 + v) % 1000003, 0)"
value "$sum"
before=$value
ask Runtime.evaluate '"expression":"document.getElementById(`yaw`).focus()"'
for key in 1 2 3 4 5; do
    for type in rawKeyDown keyUp; do
        ask Input.dispatchKeyEvent \
            "\"type\":\"$type\",\"key\":\"ArrowRight\",\"windowsVirtualKeyCode\":39"
    done
done
shows "the slider moved" "document.getElementById('yaw').value === '5'"
shows "another picture, whole again" "document.getElementById('status').textContent === '' &&
    images.reference.width === 640 &&
    $sum !== $before"
ask Runtime.evaluate '"expression":"document.getElementById(`reset`).click()"'
shows "the scene's own camera again" "images.reference.width === 640 &&
    $sum === $before"

# A click: both explanations of the pixel under it, and the first difference.
value "(b => Math.round(b.left + b.width / 2) + ' ' + Math.round(b.top + b.height / 2))(
    document.getElementById('mine').getBoundingClientRect())"
box=$value
for type in mousePressed mouseReleased; do
    ask Input.dispatchMouseEvent \
        "\"type\":\"$type\",\"x\":${box% *},\"y\":${box#* },\"button\":\"left\",\"clickCount\":1"
done
shows "the pixel in the middle" "Math.abs(document.getElementById('row').value - 240) <= 2 &&
    Math.abs(document.getElementById('column').value - 320) <= 2"
shows "its story" "['d_r = ', 'Triangle{', '8-bit = '].every(
    words => document.getElementById('story').textContent.includes(words))"
shows "one first line that differs, the color" "document.querySelectorAll('.first').length === 1 &&
    document.querySelector('.first .mine').textContent.includes('color = ') &&
    document.querySelector('.first .mine').textContent !==
    document.querySelector('.first .reference').textContent"
shows "the first difference" "/^The first difference: .*color, of /.test(
    document.getElementById('explanation').textContent)"

# Its rays in three dimensions, with the numbers of the story; the keyboard turns them.
shows "the pixel's rays" "(space.drawn()?.rays ?? []).length > 0 &&
    space.drawn().rays.every(ray => document.getElementById('story').textContent.includes(
        'hit at t = ' + /at t = ([^,]*)/.exec(ray.words)[1])) &&
    document.querySelectorAll('#rays-list li').length === space.drawn().rays.length"
shows "the shapes' outlines" "space.drawn().outlines.some(one => one.hit) &&
    document.getElementById('rays').width > 100"
value "space.turned().join()"
before=$value
ask Runtime.evaluate '"expression":"document.getElementById(`rays`).focus()"'
ask Input.dispatchKeyEvent '"type":"rawKeyDown","key":"ArrowRight","windowsVirtualKeyCode":39'
shows "turned rays" "space.turned().join() !== '$before'"

# A compiler error, and then a right program: reported, and rendered again, without a click.
echo "triangle.cpp:7:3: error: expected ';'" > project/compiler_says
echo "a line" >> project/steps/step05_triangle/student/triangle.cpp
shows "the compiler's error" "!document.querySelector('[data-of=mine] pre').hidden &&
    document.querySelector('[data-of=mine] pre').textContent.includes('triangle.cpp:7:3: error')"
rm project/compiler_says
program step05_triangle
echo "another" >> project/steps/step05_triangle/student/triangle.cpp
shows "no difference once it is right" "$caption.startsWith('The same picture as ')"
shows "no error any more" "document.querySelector('[data-of=mine] pre').hidden"
explanation="document.getElementById('explanation').textContent"

# Depths: both on one scale, whose legend has numbers.
colors() {
    ask Runtime.evaluate "\"expression\":\"shade.value = $1; shade.onchange()\""
}
colors 2
shows "a legend" "/^depth: .*in units of the scene/.test(document.querySelector('#legend p').textContent) &&
    document.querySelectorAll('#legend .scale span').length > 2"
shows "depths that are the same" "$caption.startsWith('The same picture as ')"
colors 3
shows "the names of shapes" "/triangle [0-9]+, .* of the pixels/.test(
    document.querySelector('#legend div').textContent)"
colors 0
shows "no legend for colors" "document.getElementById('legend').hidden &&
    $caption.startsWith('The same picture as ')"
shows "the same story" "$explanation === 'Nothing differs.'"

# Numbers are compared, not texts; a function that is not written is reported, and no difference.
script "echo 'steps/step04_plane/student/plane.cpp:7: intersect is not written yet' >&2
\"$build/step05_triangle\" \"\$@\" | sed 's/\([(, ]\)0\([,)]\)/\1-0\2/g; s/\(\.[0-9]\{9\}\)[0-9]*/\1/g'"
touch project/steps/step05_triangle/student/triangle.cpp
shows "no difference by the sign of zero or the last digits" "
    $explanation.startsWith('Nothing differs.') && document.querySelector('.differs') === null"
shows "what is not written" "$explanation.includes('plane.cpp:7: intersect is not written yet')"

# Whose files draw the picture.
parts="document.getElementById('parts').textContent"
shows "the stages of mine" "$parts.includes('stages of yours: 5, and with the references of: 1, 2, 3, 4')"
mkdir -p project/steps/step03_sphere/student
touch project/steps/step03_sphere/student/sphere.cpp
program step05_triangle "--shade normal"
shows "two of mine" "$parts.includes('stages of yours: 3, 5, and') && $parts.includes('all but stage 5')"
rm -r project/steps/step03_sphere
shows "a program that is replaced is drawn anew" "/pixels differ/.test($caption)"

# A program that crashes, and an endless one: reported, and the page still works.
script 'kill -SEGV $$'
shows "a crash" "document.querySelector('[data-of=mine] pre').textContent.includes('it crashed')"
script "$endless"
began || fail "a program without end is drawn"
is "the reference does not wait for it" 200 "${address}picture?$drawing&whose=1"

# Ctrl-C ends it immediately, with its programs, and leaves nothing.
started=$(date +%s)
kill -INT "$server"
wait "$server"
[ $? = 0 ] || fail "Ctrl-C is a good end"
server=
[ $(($(date +%s) - started)) -lt 20 ] || fail "Ctrl-C does not wait for them"
[ -z "$(ls temporary)" ] || fail "Ctrl-C leaves no file"
kill -0 "$(cat endless)" 2> /dev/null && fail "Ctrl-C leaves no program"
shows "that it was stopped" "document.getElementById('status').textContent.includes('was stopped')"

exit $failed
