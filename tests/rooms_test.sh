#!/bin/sh
# The rooms of common/ are layers: rooms_test.sh PROJECT_FOLDER
#
# Fails if a file includes one of a room beside or above its own, if the same happens among the folders
# of common/course, if common/course includes anything of the ray tracer but pictures, if common/ or
# steps/ include tests, pages or scenes, if a file lies flat in common/ or in no room, if a test
# includes Catch2 itself (tests/kit/catch.hpp knows both of its versions), and if the title of a
# suite's case has another word than hit, miss or uniform.
cd "$1" || exit 2

# Prints what is wrong in lines "FILE INCLUDED", and nothing for those that are right.
judge() {
    awk '
        # Reads pairs "room=layer".
        function read_order(order, layers,    pairs, pair, i) {
            for (i = split(order, pairs, " "); i > 0; --i) {
                split(pairs[i], pair, "=")
                layers[pair[1]] = pair[2]
            }
        }
        BEGIN {
            read_order("math=0 stages=0 system=0 geometry=1 image=1 bvh=2 mesh_file=2 scene=3 " \
                "exact=4 explain=4 scene_file=4 render=5 steps=6 tuning=6 contract=7 program=7", layer)
            course["course"] = course["system"] = course["stages"] = course["image"] = 1
            read_order("build=0 grade/sandbox=0 exercise=1 authoring=2 grade/results=2 own=2 view=2 " \
                "book=3 grade/judging=3 grade/reports=3 handout=4 grade=5 course=6", floor)
        }
        function folder(path) {
            sub("^common/", "", path)
            sub("/[^/]*$", "", path)
            sub("^course/", "", path)
            return path
        }
        function is_below(to, from) {
            return to == from || to in floor && from in floor && floor[to] < floor[from]
        }
        function room(path,    parts) {
            split(path, parts, "/")
            return parts[1] == "common" ? parts[2] : parts[1]
        }
        {
            from = room($1)
            to = room($2)
            if (from == "course" && to == "course" ? is_below(folder($2), folder($1)) : from == to)
                next
            if (from == "course" ? to != from && to in course : from in layer && to in layer && layer[to] < layer[from])
                next
            print $1 ": includes " $2
        }'
}

includes() {
    grep -rE --include='*.?pp' '^ *# *include "' common steps |
        sed -E 's/^([^:]*): *# *include "([^"]*)".*/\1 \2/'
}

flat() {
    find common -maxdepth 1 -type f ! -name CMakeLists.txt ! -name README.md | sed 's/$/: lies in no room/'
}

catch2() {
    grep -rlE --include='*.?pp' '^ *# *include <catch2/' tests | grep -v '^tests/kit/' |
        sed 's/$/: includes Catch2 itself/'
}

titles() {
    grep -rA1 'TEST_CASE(' tests/suites | grep -F '"' | grep -wE 'met|meets?|even|evenly' |
        grep -v ' even if ' | sed 's/$/: a hit, a miss, uniform, well spread/'
}

# The rules themselves: of these lines each is wrong.
missed=$({
    echo "common/math/real.hpp common/geometry/ray.hpp"
    echo "common/explain/text.hpp common/exact/leader.hpp"
    echo "common/scene_file/reader.cpp steps/step02_camera_basis/camera_basis.hpp"
    echo "common/tuning/auto_settings.hpp common/program/options.hpp"
    echo "common/course/main.cpp common/scene/scene.hpp"
    echo "common/render/render.cpp common/course/main.hpp"
    echo "common/course/grade/results/term.hpp common/course/grade/reports/csv.hpp"
    echo "common/course/book/site.cpp common/course/handout/manifest.hpp"
    echo "common/course/build/build.cpp common/course/new/new.hpp"
    echo "common/elsewhere/new.cpp common/math/real.hpp"
    echo "steps/step03_sphere/main.cpp tests/kit/picture.hpp"
} | judge | wc -l)
[ "$missed" = 11 ] || { echo "of 11 wrong includes only $missed are found"; exit 1; }
[ "$(includes | wc -l)" -gt 500 ] || { echo "includes are not found"; exit 1; }

wrong=$(includes | judge; flat; catch2; titles)
[ -z "$wrong" ] || { echo "$wrong"; exit 1; }
