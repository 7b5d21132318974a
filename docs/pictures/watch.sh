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

# sphere SQUARE: a student's file, with this for r²
sphere() {
    cat << END
#include "steps/step03_sphere/sphere.hpp"

#include "common/math/vector.hpp"

#include <algorithm>
#include <cmath>

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Sphere& sphere, Interval interval) {
    const Vec3 to_origin = ray.origin - sphere.center;
    const Real a = dot(ray.direction, ray.direction);
    const Real b = 2 * dot(ray.direction, to_origin);
    const Real c = dot(to_origin, to_origin) - $1;
    const Real discriminant = b * b - 4 * a * c;
    if (!(discriminant >= 0)) return std::nullopt;
    const Real root = std::sqrt(discriminant);
    for (const Real t : {(-b - root) / (2 * a), (-b + root) / (2 * a)})
        if (interval.contains(t)) return t;
    return std::nullopt;
}

Vec3 normal(const Sphere& sphere, Vec3 point) {
    return unit(point - sphere.center);
}

Color color_from_normal(Vec3 normal) {
    return Color(abs(unit(normal)));
}

Real torch(Vec3 point, Vec3 normal, Vec3 eye) {
    if (point == eye) return 0;
    return std::max(Real(0), dot(unit(eye - point), unit(normal)));
}

}  // namespace rt
END
}

./course start 3 > /dev/null
tmux -L raysteps -f /dev/null new-session -d -s watch -x 80 -y 24 './course watch 3'
trap 'tmux -L raysteps kill-server; rm -rf "$folder"' EXIT
frame 1 'ot written yet'
sphere sphere.radius > $mine/sphere.cpp
rm $mine/main.cpp  # a student may write the functions alone
frame 2 'You subtract'
sphere "sphere.radius * sphere.radius" > $mine/sphere.cpp
frame 3 'the same picture'
./course run 3 --size 480x360 -o "$folder/picture.png" > /dev/null
python3 "$project/docs/pictures/animate.py" "$folder"/frames/* "$folder/picture.png" > "$folder/watch.svg"
mv "$folder/watch.svg" "$project/docs/pictures/watch.svg"
