#!/bin/sh
# The engine of the book's figures as WebAssembly: build.sh PROJECT OUT
#
# Writes OUT/engine_double.wasm and OUT/engine_float.wasm. Needs Debian's clang, lld and, of 14 MB,
# wasi-libc, libc++-16-dev-wasm32, libc++abi-16-dev-wasm32 and libclang-rt-16-dev-wasm32: without one of
# these it says so and writes nothing. Compiles all again if one of the project's files is newer.
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
[ -e /usr/include/wasm32-wasi/c++/v1/optional ] || missing libc++-16-dev-wasm32
[ -e /usr/lib/wasm32-wasi/libc++abi.a ] || missing libc++abi-16-dev-wasm32
builtins=$(find /usr/lib/llvm-*/lib/clang -name libclang_rt.builtins-wasm32.a 2> /dev/null | head -n 1)
[ -n "$builtins" ] || missing libclang-rt-16-dev-wasm32

if [ -e "$out/engine_double.wasm" ] && [ -e "$out/engine_float.wasm" ]; then
    newer=$(find common steps docs/figures/engine -name '*.?pp' -newer "$out/engine_double.wasm" | head -n 1)
    [ -n "$newer" ] || exit 0
fi

# GLM only: the machine's other headers would hide the library's own.
glm=$(find /usr/include /usr/local/include -path '*/glm/glm.hpp' | head -n 1)
ln -sfn "${glm%/*}" "$out/include/glm"
flags="--target=wasm32-wasi -std=c++20 -O2 -ffp-contract=off -fno-math-errno -fignore-exceptions
    -DGLM_FORCE_CTOR_INIT -I. -I$out/include"

# Compiled as one file, which takes a third of the time.
for source in docs/figures/engine/engine.cpp docs/figures/engine/questions.cpp \
    docs/figures/engine/no_exceptions.cpp common/explain/*.cpp common/render/sampling.cpp \
    common/render/surface.cpp steps/*/reference/*.cpp steps/*/story.cpp; do
    echo "#include \"$source\""
done > "$out/whole.cpp"

# engine PRECISION [OPTION…]
engine() {
    precision=$1
    shift
    # shellcheck disable=SC2086  # words
    $compiler $flags "$@" -nodefaultlibs -mexec-model=reactor -Wl,--strip-all \
        -Wl,--export=engine_room,--export=engine_ask,--export=engine_describe,--export=engine_result \
        "$out/whole.cpp" -lc++ -lc++abi -lc "$builtins" -o "$out/new_$precision.wasm"
}

engine float -DRT_FLOAT &
engine double
wait $!
mv "$out/new_float.wasm" "$out/engine_float.wasm"
mv "$out/new_double.wasm" "$out/engine_double.wasm"
