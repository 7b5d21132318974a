#!/bin/sh
# Builds for another platform, runs the suites, and compares pictures with this machine's:
#     sh tests/platforms/platform.sh PLATFORM         all that docs/reference/building.md says of it
#     sh tests/platforms/platform.sh PLATFORM ci      a selection, in a minute or two
#     sh tests/platforms/platform.sh PLATFORM TARGET…
#
#     libcxx     clang++ 16 with libc++, the compiler and the library of macOS; long double is double
#     oldest     g++ 11, that of Ubuntu 22.04
#     aarch64    a cross compiler of g++; its programs run in qemu
#     windows    mingw-w64's g++; its programs run in wine
#
# `libcxx syntax` and `libcxx syntax all` run syntax.sh alone.
# Targets *_test_* are run, and the other step* draw their scene in both precisions; each picture
# must have the bytes of ./build's, which this builds too.
# Debian's packages are unpacked in build/platforms, and nothing is installed, except for cross
# compilers and emulators, which are named if they are missing.
# shellcheck disable=SC2046  # no name has a blank
set -eu
platform=${1:-none}
[ $# = 0 ] || shift
what=${1:-all}
root=$(CDPATH='' cd -- "$(dirname "$0")/../.." && pwd -P)
tools=$root/build/platforms/tools
build=build/platforms/$platform
options=
linking=  # options of the linker
emulator=
suffix=
size=320x240
scenes=  # those of the pictures, if not the stage's own
also=  # commands after the suites and the pictures
mkdir -p "$tools/packages"
cd "$root"

fail() {
    echo "error: $1" >&2
    exit "${2:-1}"
}

need() {
    command -v "$1" > /dev/null || [ -x "$1" ] || fail "$1 is missing: apt-get install $2" 2
}

# shellcheck source=tests/platforms/libraries.sh
. "$root/tests/platforms/libraries.sh"

# stages: the programs of all stages
stages() {
    for stage in steps/step*; do
        [ ! -d "$stage" ] || echo "${stage#*/}"
    done
}

# suites: those of all stages, in both precisions
suites() {
    for stage in $(stages); do
        for suite in "$stage" "${stage}_trace"; do
            [ ! -e "tests/suites/${suite}_test.cpp" ] && [ ! -d "tests/suites/$suite" ] ||
                echo "${suite}_test_float ${suite}_test_double"
        done
    done
}

# A student's stage 5, in a copy of the project.
first_stage() {
    ninja_here step05_triangle
    LDFLAGS=$linking sh tests/platforms/student.sh "$root" $options
}

# A student's way through stage 3, in a copy of the project.
way() {
    CXX=$tools/clang++ CXXFLAGS=-DRAYSTEPS_SHORT_LONG_DOUBLE LDFLAGS=$linking \
        sh tests/programs/course_test.sh "$root"
}

# The page of `./course view` in Chromium, if that is installed.
page() {
    sh tests/programs/view_test.sh "$root/$build" "$root" || [ $? = 77 ]
}

# The tests of CMake but the counts of this machine's compiler, and the pages as a site.
tests() {
    ctest --test-dir "$build" --output-on-failure -E '^(instruction_counts|book)$'
}

# run SUITE: prints its last line, or everything if it fails
run() {
    $emulator "$build/$1$suffix" > "$build/$1.log" 2>&1 || { cat "$build/$1.log"; return 1; }
    echo "$1: $(grep 'All tests passed' "$build/$1.log")"
}

# ninja_here TARGET: for this machine
ninja_here() {
    [ -e build/build.ninja ] || cmake -S . -B build -G Ninja
    ninja -C build "$1"
}

# draw STAGE SCENE: the same bytes as this machine's
draw() {
    for precision in float double; do
        # In float, the C library's sine, cosine or power differs in the last digit: a pixel differs by 1.
        case $platform-$2-$precision in windows-step1[12]_*-float) continue ;; esac
        drawing="scenes/$2.rt --size $size --precision $precision -o $build"
        "build/$1" $drawing/here.png
        $emulator "$build/$1$suffix" $drawing/there.png
        cmp "$build/here.png" "$build/there.png" || return
        echo "$2, $precision: $(md5sum < "$build/there.png")"
    done
}

# A hand-out for two kinds of processors, on the other one: stage 5 from the archives.
handed_out() (
    rm -rf "$build/handout"
    ./course handout "$build/handout" --also aarch64 && cmake -S "$build/handout" -B "$build/handed_out" -G Ninja $options &&
        ninja -C "$build/handed_out" step05_triangle step05_triangle_test_double || return
    build=$build/handed_out
    run step05_triangle_test_double && draw step05_triangle step05_triangle
)

# The targets, by the platform's name and what is asked. In a selection, what another compiler or
# library accepts is compiled without optimization, and what another processor or system does with it.
case $platform-$what in
    libcxx-all)
        set -- $(stages) $(suites) hierarchy_test_float hierarchy_test_double \
            mesh_reader_test_float mesh_reader_test_double course course_test view_server
        also="first_stage way page"
        ;;
    libcxx-ci)
        set --
        also=first_stage
        options=-DCMAKE_BUILD_TYPE=None
        ;;
    oldest-all)
        set -- all
        also=tests
        ;;
    oldest-ci)
        set -- step13_meshes step05_triangle_test_double course
        scenes="step05_triangle step12_mirror step13_meshes"
        options=-DCMAKE_BUILD_TYPE=None
        ;;
    aarch64-all)
        set -- step05_triangle step12_mirror step13_meshes step03_sphere_test_float \
            step03_sphere_test_double step05_triangle_test_float step05_triangle_test_double \
            hierarchy_test_float hierarchy_test_double mesh_reader_test_float mesh_reader_test_double
        size=160x120
        also=handed_out
        ;;
    aarch64-ci)
        set -- step13_meshes step03_sphere_test_float step05_triangle_test_float
        scenes="step05_triangle step12_mirror step13_meshes"
        ;;
    windows-all) set -- $(stages) $(suites) ;;
    windows-ci)
        set -- step12_mirror step05_triangle_test_double
        scenes="step05_triangle step12_mirror"
        ;;
esac
if [ "$what" = ci ]; then
    build=$build/ci
    size=80x60
fi
case $platform in
    libcxx)
        unpack clang-16 libclang-cpp16 libllvm16 libclang-common-16-dev libc++-16-dev libc++1-16 \
            libc++abi-16-dev libc++abi1-16 libunwind-16 libunwind-16-dev
        llvm=$tools/usr/lib/llvm-16
        linking=-Wl,-rpath,$llvm/lib
        cat > "$tools/clang++" << END
#!/bin/sh
LD_LIBRARY_PATH=$tools/usr/lib/x86_64-linux-gnu exec $llvm/bin/clang++ -stdlib=libc++ "\$@"
END
        chmod +x "$tools/clang++"
        [ "$what" != syntax ] || exec sh tests/platforms/syntax.sh "$tools/clang++" "${2-}"
        # Debian's Boost is too old for libc++ in C++20.
        options="$options -DCMAKE_CXX_COMPILER=$tools/clang++ -DRAYSTEPS_ANY_PROCESSOR=ON
            -DCMAKE_CXX_FLAGS=-DRAYSTEPS_SHORT_LONG_DOUBLE
            -DCMAKE_DISABLE_FIND_PACKAGE_Boost=ON"
        openmesh_if_needed libcxx "$tools/clang++" "$@"
        ;;
    oldest)
        unpack g++-11 gcc-11 gcc-11-base cpp-11 libstdc++-11-dev libstdc++6 libgcc-11-dev
        options="$options -DCMAKE_CXX_COMPILER=$tools/usr/bin/g++-11"
        ;;
    aarch64)
        need aarch64-linux-gnu-g++ g++-aarch64-linux-gnu
        need qemu-aarch64-static qemu-user-static
        emulator="qemu-aarch64-static -L /usr/aarch64-linux-gnu"
        options="-DCMAKE_SYSTEM_NAME=Linux -DCMAKE_SYSTEM_PROCESSOR=aarch64
            -DCMAKE_C_COMPILER=aarch64-linux-gnu-gcc -DCMAKE_CXX_COMPILER=aarch64-linux-gnu-g++"
        headers
        from_packages arm64 aarch64-linux-gnu
        ;;
    windows)
        need x86_64-w64-mingw32-g++-posix g++-mingw-w64-x86-64-posix
        need /usr/lib/wine/wine64 wine64
        need ld.lld lld
        emulator="env WINEDEBUG=-all WINEPREFIX=$tools/wine /usr/lib/wine/wine64"
        suffix=.exe
        options="-DCMAKE_SYSTEM_NAME=Windows -DCMAKE_SYSTEM_PROCESSOR=AMD64
            -DCMAKE_C_COMPILER=x86_64-w64-mingw32-gcc-posix
            -DCMAKE_CXX_COMPILER=x86_64-w64-mingw32-g++-posix
            -DCMAKE_RC_COMPILER=x86_64-w64-mingw32-windres"
        linking="-static -B$tools/lld"
        fast_linker
        wine_folder /usr/lib/x86_64-linux-gnu/wine/x86_64-windows
        headers
        png_from_source x86_64-w64-mingw32
        openmesh_if_needed x86_64-w64-mingw32 x86_64-w64-mingw32-g++-posix "$@"
        ;;
    *) fail "expected libcxx, oldest, aarch64 or windows, not \"$platform\"" 2 ;;
esac

if [ $# != 0 ]; then
    LDFLAGS=$linking cmake -S . -B "$build" -G Ninja $options
    ninja -C "$build" "$@"
fi
failed=0
[ "${1-}" != all ] || set -- $(stages)
for target in "$@"; do
    case $target in
        *_test_*) run "$target" || failed=1 ;;
        step*)
            ninja_here "$target"
            for scene in ${scenes:-$target}; do draw "$target" "$scene" || failed=1; done
            ;;
    esac
done
for part in $also; do "$part" || failed=1; done
[ $failed != 0 ] || echo "$platform: passed, with the same bytes"
exit $failed
