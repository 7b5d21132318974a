#!/bin/sh
# Builds targets for another platform, and compares pictures with this machine's:
#     sh tests/platforms/platform.sh PLATFORM [TARGET…]
#
#     libcxx     clang++ 16 with libc++, the compiler and the library of macOS; long double is double
#     oldest     g++ 11, that of Ubuntu 22.04
#     aarch64    a cross compiler of g++; its programs run in qemu
#     windows    mingw-w64's g++; its programs run in wine
#
# Without a target: step05_triangle. `libcxx syntax` and `libcxx syntax all` run syntax.sh alone.
# Targets step*_test_* are run, and the other step* draw their scene in both precisions; each
# picture must have the bytes of ./build's, which this builds too.
# Debian's packages are unpacked in build/platforms, and nothing is installed, except for cross
# compilers and emulators, which are named if they are missing.
set -eu
platform=${1:-none}
[ $# = 0 ] || shift
[ $# != 0 ] || set -- step05_triangle
root=$(CDPATH='' cd -- "$(dirname "$0")/../.." && pwd -P)
tools=$root/build/platforms/tools
build=$root/build/platforms/$platform
mkdir -p "$tools/packages"

fail() {
    echo "error: $1" >&2
    exit "${2:-1}"
}

need() {
    command -v "$1" > /dev/null || [ -x "$1" ] || fail "$1 is missing: apt-get install $2" 2
}

# unpack PACKAGE…
unpack() {
    for package in "$@"; do
        [ ! -e "$tools/packages/$package" ] || continue
        (cd "$tools/packages" && apt-get -qq download "$package" 2> "$package.log" ||
            { apt-get -qq update && apt-get -qq download "$package" 2> "$package.log"; }) ||
            { cat "$tools/packages/$package.log" >&2; fail "$package cannot be downloaded: apt-get update" 2; }
        dpkg -x "$tools/packages/$package"_*.deb "$tools"
        : > "$tools/packages/$package"
    done
}

# The headers of the libraries, and zlib and libpng from Debian's sources: libraries TARGET-TRIPLE
libraries() {
    unpack libglm-dev libcli11-dev catch2
    mkdir -p "$tools/source/lists/partial" "$tools/source/parts" "$tools/$1"
    cd "$tools/source"
    if ! ls libpng*.tar.* zlib*.tar.* > /dev/null 2>&1; then
        cat /etc/apt/sources.list.d/*.sources 2> /dev/null | sed 's/^Types:.*/Types: deb-src/' > parts/all.sources
        sed -n 's/^deb /deb-src /p' /etc/apt/sources.list 2> /dev/null > parts/all.list || :
        set -- "$1" -qq -o Dir::State::Lists="$PWD/lists" -o Dir::Etc::SourceList=/dev/null \
            -o Dir::Etc::SourceParts="$PWD/parts" -o Dir::Cache::SrcPkgCache= -o Dir::Cache::PkgCache=
        triple=$1
        shift
        apt-get "$@" update
        apt-get "$@" source --download-only --tar-only libpng1.6 zlib
        set -- "$triple"
        for archive in libpng*.orig.tar.* zlib*.orig.tar.*; do tar -xf "$archive"; done
    fi
    if [ ! -e "$tools/$1/lib/libpng.a" ]; then
        mkdir -p "$tools/$1/lib" "$tools/$1/include" "$tools/$1/objects"
        cp zlib-*/zlib.h zlib-*/zconf.h libpng-*/png.h libpng-*/pngconf.h "$tools/$1/include"
        cp libpng-*/scripts/pnglibconf.h.prebuilt "$tools/$1/include/pnglibconf.h"
        for source in zlib-*/[a-fh-z]*.c libpng-*/png*.c; do
            case $source in */pngtest.c) continue ;; esac
            "$1-gcc" -O2 -DPNG_ARM_NEON_OPT=0 -I"$tools/$1/include" -c "$source" \
                -o "$tools/$1/objects/$(basename "$source").o"
        done
        (cd "$tools/$1/objects" && "$1-ar" rcs ../lib/libz.a [a-oq-z]*.o && "$1-ar" rcs ../lib/libpng.a p*.o)
    fi
    cd "$root"
    set -- "$tools/$1"
    options="$options -Dglm_DIR=$tools/usr/share/cmake/glm -DCLI11_DIR=$tools/usr/share/cmake/CLI11
        -DCatch2_DIR=$tools/usr/lib/cmake/Catch2 -DCMAKE_DISABLE_FIND_PACKAGE_OpenMesh=ON
        -DPNG_PNG_INCLUDE_DIR=$1/include -DPNG_LIBRARY=$1/lib/libpng.a
        -DZLIB_INCLUDE_DIR=$1/include -DZLIB_LIBRARY=$1/lib/libz.a -DRAYSTEPS_ANY_PROCESSOR=ON
        -DCMAKE_DISABLE_FIND_PACKAGE_Boost=ON"
}

options=
emulator=
suffix=
case $platform in
    libcxx)
        unpack clang-16 libclang-cpp16 libllvm16 libclang-common-16-dev libc++-16-dev libc++1-16 \
            libc++abi-16-dev libc++abi1-16 libunwind-16 libunwind-16-dev
        llvm=$tools/usr/lib/llvm-16
        cat > "$tools/clang++" << END
#!/bin/sh
LD_LIBRARY_PATH=$tools/usr/lib/x86_64-linux-gnu exec $llvm/bin/clang++ -stdlib=libc++ "\$@"
END
        chmod +x "$tools/clang++"
        [ "$1" != syntax ] || exec sh "$root/tests/platforms/syntax.sh" "$tools/clang++" ${2-}
        # OpenMesh and Debian's Boost are made for libstdc++.
        options="-DCMAKE_CXX_COMPILER=$tools/clang++ -DRAYSTEPS_ANY_PROCESSOR=ON
            -DCMAKE_CXX_FLAGS=-DRAYSTEPS_SHORT_LONG_DOUBLE
            -DCMAKE_EXE_LINKER_FLAGS=-Wl,-rpath,$llvm/lib
            -DCMAKE_DISABLE_FIND_PACKAGE_OpenMesh=ON -DCMAKE_DISABLE_FIND_PACKAGE_Boost=ON"
        ;;
    oldest)
        unpack g++-11 gcc-11 gcc-11-base cpp-11 libstdc++-11-dev libgcc-11-dev
        options="-DCMAKE_CXX_COMPILER=$tools/usr/bin/g++-11"
        ;;
    aarch64)
        need aarch64-linux-gnu-g++ g++-aarch64-linux-gnu
        need qemu-aarch64-static qemu-user-static
        emulator="qemu-aarch64-static -L /usr/aarch64-linux-gnu"
        options="-DCMAKE_SYSTEM_NAME=Linux -DCMAKE_SYSTEM_PROCESSOR=aarch64
            -DCMAKE_C_COMPILER=aarch64-linux-gnu-gcc -DCMAKE_CXX_COMPILER=aarch64-linux-gnu-g++"
        libraries aarch64-linux-gnu
        ;;
    windows)
        need x86_64-w64-mingw32-g++-posix g++-mingw-w64-x86-64-posix
        need /usr/lib/wine/wine64 wine64
        emulator="env WINEDEBUG=-all WINEPREFIX=$tools/wine WINEPATH=Z:$tools/bin /usr/lib/wine/wine64"
        suffix=.exe
        options="-DCMAKE_SYSTEM_NAME=Windows -DCMAKE_SYSTEM_PROCESSOR=AMD64
            -DCMAKE_C_COMPILER=x86_64-w64-mingw32-gcc-posix
            -DCMAKE_CXX_COMPILER=x86_64-w64-mingw32-g++-posix
            -DCMAKE_RC_COMPILER=x86_64-w64-mingw32-windres -DCMAKE_EXE_LINKER_FLAGS=-static"
        libraries x86_64-w64-mingw32
        ;;
    *) fail "expected libcxx, oldest, aarch64 or windows, not \"$platform\"" 2 ;;
esac

cd "$root"
# An archive of CMake's precompiled headers, or mold, may not fit another compiler.
cmake -S . -B "$build" -G Ninja $options
ninja -C "$build" "$@"

failed=0
for target in "$@"; do
    case $target in
        *_test_*) $emulator "$build/$target$suffix" || failed=1 ;;
        step*)
            ninja -C build "$target"
            scene=scenes/$target.rt
            for precision in float double; do
                options="--size 320x240 --precision $precision -o"
                "build/$target" "$scene" $options "$build/here.png"
                $emulator "$build/$target$suffix" "$scene" $options "build/platforms/$platform/there.png"
                cmp "$build/here.png" "$build/there.png" || failed=1
                md5sum "$build/there.png"
            done
            ;;
    esac
done
[ $failed = 0 ] && echo "$platform: the same bytes"
exit $failed
