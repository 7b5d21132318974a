#!/bin/sh
# Draws docs/pictures/watch.svg, the README's animation: `./course watch 3` in a terminal, while a
# student writes stage 3. From the project's folder:
#
#     sh docs/pictures/watch.sh
#
# It works in a copy of the project, which it builds (two minutes). Needs tmux and python3.
set -eu
project=$(cd "$(dirname "$0")/../.." && pwd)
command -v tmux > /dev/null || { echo "this needs tmux: apt-get install tmux" >&2; exit 2; }
. "$project/tests/lib.sh"
mkdir "$folder/copy" "$folder/frames"
copy_project "$project" "$folder/copy"
cd "$folder/copy"
mine=steps/step03_sphere/student

# frame NAME WORDS: the terminal, once these words are there
frame() {
    until_true 120 sh -c "tmux -L raysteps capture-pane -p -t watch | grep -q '$2'" ||
        { tmux -L raysteps capture-pane -p -t watch; exit 1; }
    sleep 1
    tmux -L raysteps capture-pane -e -p -t watch > "$folder/frames/$1"
}

right=steps/step03_sphere/reference/sphere.cpp
./course start 3 > /dev/null
tmux -L raysteps -f /dev/null new-session -d -s watch -x 80 -y 24 './course watch 3'
trap 'tmux -L raysteps kill-server; rm -rf "$folder"' EXIT
frame 1 'ot written yet'
sed 's/radius \* sphere.radius/radius/' $right > $mine/sphere.cpp
rm $mine/main.cpp  # a student may write the functions alone
frame 2 'You subtract'
cp $right $mine/sphere.cpp
frame 3 'the same picture'
./course run 3 --size 480x360 -o "$folder/picture.png" > /dev/null
python3 "$project/docs/pictures/animate.py" "$folder"/frames/* "$folder/picture.png" > "$folder/watch.svg"
mv "$folder/watch.svg" "$project/docs/pictures/watch.svg"
