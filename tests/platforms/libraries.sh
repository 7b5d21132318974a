# shellcheck shell=sh disable=SC2154,SC2164  # platform.sh sets these, and -e
# The libraries of another platform, from Debian's packages and sources: platform.sh sources this
# file. Everything is put in $tools, and the options of CMake in $options.

# apt ARCHITECTURE WORDS…: apt-get with package lists of its own, so that nothing is installed, and
# no list of the machine is changed. The architecture is a processor's, or `source`.
apt() {
    lists=$tools/lists/$1
    mkdir -p "$lists/state/partial" "$lists/sources"
    case $1 in
        source)
            cat /etc/apt/sources.list.d/*.sources 2> /dev/null | sed 's/^Types:.*/Types: deb-src/' > "$lists/sources/all.sources"
            sed -n 's/^deb /deb-src /p' /etc/apt/sources.list 2> /dev/null > "$lists/sources/all.list" || :
            set -- "$@" -o Dir::Etc::SourceList=/dev/null -o Dir::Etc::SourceParts="$lists/sources"
            ;;
        *) set -- "$@" -o APT::Architecture="$1" -o APT::Architectures::="$1" -o Dir::State::Status=/dev/null ;;
    esac
    shift
    apt-get -qq -o Dir::State::Lists="$lists/state" -o Dir::Cache::SrcPkgCache= -o Dir::Cache::PkgCache= \
        -o Acquire::Languages=none -o APT::Sandbox::User= "$@"
}

# unpack PACKAGE…: this machine's packages, in $tools
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

# headers: the libraries that consist of headers
headers() {
    unpack libglm-dev libcli11-dev catch2
    options="$options -Dglm_DIR=$tools/usr/share/cmake/glm -DCLI11_DIR=$tools/usr/share/cmake/CLI11
        -DCatch2_DIR=$tools/usr/lib/cmake/Catch2 -DCMAKE_DISABLE_FIND_PACKAGE_Boost=ON
        -DRAYSTEPS_ANY_PROCESSOR=ON"
}

# from_packages ARCHITECTURE TRIPLE: libpng, zlib and OpenMesh, as Debian compiled them
from_packages() {
    folder=$tools/$1
    if [ ! -e "$folder/unpacked" ]; then
        mkdir -p "$folder/packages"
        apt "$1" update
        (cd "$folder/packages" && apt "$1" download libpng-dev zlib1g-dev libopenmesh-dev libopenmesh1)
        for package in "$folder"/packages/*.deb; do dpkg -x "$package" "$folder"; done
        : > "$folder/unpacked"
    fi
    png "$folder/usr/include" "$folder/usr/lib/$2"
    options="$options -DOpenMesh_DIR=$folder/usr/lib/$2/cmake/OpenMesh"
}

# png INCLUDES LIBRARIES
png() {
    options="$options -DPNG_PNG_INCLUDE_DIR=$1 -DPNG_LIBRARY=$2/libpng.a
        -DZLIB_INCLUDE_DIR=$1 -DZLIB_LIBRARY=$2/libz.a"
}

# source_of PACKAGE: its source, unpacked in $tools/source
source_of() {
    mkdir -p "$tools/source"
    cd "$tools/source"
    if ! ls "$1"_*.orig.tar.* > /dev/null 2>&1; then
        [ -n "$(find "$tools/lists/source" -name '*Sources*' 2> /dev/null)" ] || apt source update
        apt source source --download-only --tar-only "$1"
        tar -xf "$1"_*.orig.tar.*
    fi
    cd "$root"
}

# png_from_source TRIPLE
png_from_source() {
    folder=$tools/$1
    if [ ! -e "$folder/lib/libpng.a" ]; then
        source_of libpng1.6
        source_of zlib
        mkdir -p "$folder/lib" "$folder/include" "$folder/objects"
        cd "$tools/source"
        cp zlib-*/zlib.h zlib-*/zconf.h libpng-*/png.h libpng-*/pngconf.h "$folder/include"
        cp libpng-*/scripts/pnglibconf.h.prebuilt "$folder/include/pnglibconf.h"
        for source in zlib-*/[a-fh-z]*.c libpng-*/png*.c; do
            case $source in */pngtest.c) continue ;; esac
            "$1-gcc" -O2 -I"$folder/include" -c "$source" -o "$folder/objects/$(basename "$source").o"
        done
        cd "$folder/objects"
        "$1-ar" rcs ../lib/libz.a [a-oq-z]*.o
        "$1-ar" rcs ../lib/libpng.a p*.o
        cd "$root"
    fi
    png "$folder/include" "$folder/lib"
}

# openmesh_from_source FOLDER COMPILER: without what writes meshes, or reads OpenMesh's own format.
# Most of it as one; BaseWriter.cc, which the readers need, defines a function that they define, too.
openmesh_from_source() {
    folder=$tools/$1
    if [ ! -e "$folder/lib/libOpenMeshCore.a" ]; then
        source_of openmesh
        mkdir -p "$folder/lib" "$folder/openmesh"
        cd "$tools"/source/OpenMesh-*/src
        find OpenMesh/Core -name '*.cc' | grep -vE '/writer/|/Templates/|/OMReader' | sort | sed 's/.*/#include "&"/' \
            > "$folder/openmesh/core.cc"
        for source in "$folder/openmesh/core.cc" OpenMesh/Core/IO/writer/BaseWriter.cc; do
            "$2" -O1 -w -I. -c "$source" -o "$folder/openmesh/$(basename "$source").o"
        done
        ar rcs "$folder/lib/libOpenMeshCore.a" "$folder"/openmesh/*.o
        cat > "$folder/openmesh/OpenMeshConfig.cmake" << END
add_library(OpenMeshCore STATIC IMPORTED GLOBAL)
set_target_properties(OpenMeshCore PROPERTIES
    IMPORTED_LOCATION $folder/lib/libOpenMeshCore.a INTERFACE_INCLUDE_DIRECTORIES $PWD)
add_library(OpenMeshTools INTERFACE IMPORTED GLOBAL)
target_link_libraries(OpenMeshTools INTERFACE OpenMeshCore)
END
        cd "$root"
    fi
    options="$options -DOpenMesh_DIR=$folder/openmesh -DCMAKE_DISABLE_FIND_PACKAGE_OpenMesh=OFF"
}

# openmesh_if_needed FOLDER COMPILER TARGET…: from its source, if a target reads meshes
openmesh_if_needed() {
    case " $* " in
        *mesh*) openmesh_from_source "$1" "$2" ;;
        *) options="$options -DCMAKE_DISABLE_FIND_PACKAGE_OpenMesh=ON" ;;
    esac
}

# wine_folder DLLS: what wine would write at its first start, which takes 16 s and 695 MB: the
# libraries are linked.
wine_folder() {
    [ -d "$1" ] && [ ! -e "$tools/wine" ] || return 0
    mkdir -p "$tools/wine/drive_c/windows" "$tools/wine/dosdevices"
    ln -s "$1" "$tools/wine/drive_c/windows/system32"
    ln -s ../drive_c "$tools/wine/dosdevices/c:"
    ln -s / "$tools/wine/dosdevices/z:"
    echo disable > "$tools/wine/.update-timestamp"
}

# fast_linker: g++ -B$tools/lld links with lld, in 0.1 s, and not with mingw-w64's ld, in 13 s
fast_linker() {
    mkdir -p "$tools/lld"
    cat > "$tools/lld/collect2" << 'END'
#!/bin/sh
# The arguments but those of g++'s plugin, which lld does not know.
count=$#
while [ $count -gt 0 ]; do
    case $1 in
        -plugin)
            shift
            count=$((count - 1))
            ;;
        -plugin-opt=*) ;;
        *) set -- "$@" "$1" ;;
    esac
    shift
    count=$((count - 1))
done
exec ld.lld "$@"
END
    chmod +x "$tools/lld/collect2"
}
