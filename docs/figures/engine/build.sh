#!/bin/sh
# The engine of the book's figures as WebAssembly: build.sh PROJECT OUT
#
# Writes OUT/engine_double.wasm and OUT/engine_float.wasm, the functions of the stages, and
# OUT/picture_double.wasm, which draws whole pictures. Needs Debian's clang, lld and, of 14 MB,
# wasi-libc, libc++-16-dev-wasm32, libc++abi-16-dev-wasm32 and libclang-rt-16-dev-wasm32 (19 in Debian 13):
# without one of these it prints its name and writes nothing. Compiles all again if one of the
# project's files is newer.
set -eu
mkdir -p "$2/include"
out=$(CDPATH='' cd -- "$2" && pwd)
cd "$1"

missing() {
    echo "the figures of the book do not run: $1 is not installed" >&2
    exit 0
}
compiler=$(command -v clang++-14 || command -v clang++) || missing clang
command -v wasm-ld-14 > /dev/null || command -v wasm-ld > /dev/null || missing lld
[ -e /usr/lib/wasm32-wasi/libc.a ] || missing wasi-libc
[ -e /usr/include/wasm32-wasi/c++/v1/optional ] || missing "libc++-16-dev-wasm32, or a newer one,"
[ -e /usr/lib/wasm32-wasi/libc++abi.a ] || missing "libc++abi-16-dev-wasm32, or a newer one,"
builtins=$(find /usr/lib/llvm-*/lib/clang -name libclang_rt.builtins-wasm32.a 2> /dev/null | head -n 1)
[ -n "$builtins" ] || missing "libclang-rt-16-dev-wasm32, or a newer one,"

if [ -e "$out/built" ]; then
    newer=$(find common steps docs/figures/engine scenes/meshes -name '*.?pp' -newer "$out/built" | head -n 1)
    [ -n "$newer" ] || exit 0
fi

# GLM only: the machine's other headers would hide the library's own.
glm=$(find /usr/include /usr/local/include -path '*/glm/glm.hpp' | head -n 1)
ln -sfn "${glm%/*}" "$out/include/glm"
flags="--target=wasm32-wasi -std=c++20 -ffp-contract=off -fno-math-errno -fignore-exceptions
    -DGLM_FORCE_CTOR_INIT -I. -I$out/include -include docs/figures/engine/one_thread.hpp
    -nodefaultlibs -mexec-model=reactor -Wl,--strip-all"

# module NAME HEADER OPTION…: NAME.wasm of the sources in whole_NAME.cpp, which exports the functions
# of the header. Compiled as one file, which takes a third of the time.
module() {
    name=$1
    exports=$(sed -n 's/^[a-z].*[ *]\([a-z_]*\)(.*/-Wl,--export=\1/p' "docs/figures/engine/$2")
    shift 2
    # shellcheck disable=SC2086  # words
    $compiler $flags $exports "$@" "$out/whole_${name%_*}.cpp" -lc++ -lc++abi -lc "$builtins" \
        -o "$out/new_$name"
}

# sources NAME FILE…: writes whole_NAME.cpp
sources() {
    name=$1
    shift
    for source; do echo "#include \"$source\""; done > "$out/whole_$name.cpp"
}

sources engine docs/figures/engine/engine.cpp docs/figures/engine/questions.cpp \
    docs/figures/engine/thrown.cpp common/explain/*.cpp common/render/sampling.cpp \
    common/render/surface.cpp common/bvh/b*.cpp common/mesh_file/triangulate.cpp \
    common/system/huge_pages.cpp scenes/meshes/owl.cpp scenes/meshes/polygons.cpp \
    steps/*/reference/*.cpp steps/*/*story.cpp
# scene_file before render, whose shaft.cpp has Axes of its own.
sources picture docs/figures/engine/picture.cpp docs/figures/engine/traces.cpp \
    docs/figures/engine/thrown.cpp docs/figures/engine/one_thread.cpp common/scene_file/*.cpp \
    common/scene/camera.cpp common/scene/mesh_instance.cpp common/scene/scene.cpp \
    common/scene/surface_points.cpp common/render/*.cpp common/bvh/*.cpp common/geometry/*.cpp \
    common/image/image.cpp common/program/load_meshes.cpp common/program/requirements.cpp \
    common/program/turntable.cpp common/stages/stages.cpp common/system/escaping.cpp \
    common/system/huge_pages.cpp common/system/input_error.cpp \
    steps/step02*/pixel_rays.cpp steps/step11*/lighting.cpp steps/step12*/reflection.cpp \
    steps/step13*/mesh_instance.cpp steps/*/queries.cpp steps/*/reference/*.cpp

# The log of --pixel, which no picture has, stays undefined. More inlining takes a sixth of the time.
module picture_double picture.hpp -O2 -msimd128 -mllvm -inline-threshold=700 -Wl,--allow-undefined \
    -Wl,--max-memory=134217728 -Wl,-z,stack-size=1048576 &
first=$!
module engine_float engine.hpp -Oz -Wl,-O2 -DRT_FLOAT
module engine_double engine.hpp -Oz -Wl,-O2
wait $first
for name in engine_float engine_double picture_double; do
    mv "$out/new_$name" "$out/$name.wasm"
done
touch "$out/built"
