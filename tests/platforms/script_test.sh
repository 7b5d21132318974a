#!/bin/sh
# shellcheck disable=SC2154  # lib.sh sets these
# What the script `course` says before its program exists: script_test.sh PROJECT_FOLDER
# Other programs take the place of cmake, ninja and apt-get; the package of ninja is missing.
project=$1
. "$(dirname "$0")/../lib.sh"
cd "$folder" || exit 1
mkdir -p bare/build tools fakes
cp "$project/course" "$project/CMakeLists.txt" bare
for tool in awk basename cat chmod date dirname env false find git grep head id mkdir mv printf pwd readlink rm sed \
    sh sleep tail tee touch tr true; do
    if command -v $tool > place; then ln -s "$(cat place)" tools; fi
done
echo 'exit 0' > bare/build/course
echo 'echo 0' > fakes/id
echo 'for log; do :; done; echo -- Detecting' > fakes/cmake
echo ':' > fakes/c++
echo ':' > fakes/clang++
# apt knows the packages in the file known; its install does what the file install says.
cat > fakes/apt-cache << 'END'
for package; do :; done
grep -qx "$package" known
END
cat > fakes/apt-get << 'END'
echo "$*" >> calls
case " $* " in *" update "*) . ./update ;; *" --assume-no "*) ;; *" install "*) . ./install ;; esac
END
for fake in fakes/* bare/build/course; do
    sed -i '1i #!/bin/sh' "$fake"
    chmod +x "$fake"
done
course() {
    expected=$1
    shift
    rm -f calls bare/build/build.ninja fakes/ninja fakes/mold
    PATH=$PWD/fakes:$PWD/tools bare/course "$@" > out 2>&1
    came=$?
    [ $came = "$expected" ] || fail "course $*: the status is $expected, not $came"
}
ninja_comes() { printf '#!/bin/sh\n' > fakes/ninja; chmod +x fakes/ninja; }
few_lines() { [ "$(wc -l < out)" -le "$1" ] || fail "at most $1 lines"; }

has_git() { command -v git > /dev/null; }  # an unpacked archive of the project goes without

# The version is the project's own, not that of a repository around it; a hand-out's is in its title.
if has_git; then git init -q . && git -c user.name=A -c user.email=a@b.c commit -q --allow-empty -m around; fi
course 0 --version
grep -qx 'Raysteps [0-9]*\.[0-9]*\.[0-9]*' out || fail "the number alone"
mkdir bare/steps
echo "Raysteps, version 1.0.0 (52c7ed4), handed out on 2026-11-21 for g++ 12" > bare/steps/handout.txt
course 0 --version
[ "$(cat out)" = "$(cat bare/steps/handout.txt)" ] || fail "a hand-out's title"
rm -rf bare/steps .git

# The commit of a clone, also one of another user, as root sees it in a container.
if has_git; then
    git init -q bare && git -C bare -c user.name=A -c user.email=a@b.c commit -q --allow-empty -m mine
    [ "$(id -u)" != 0 ] || chown -R 1 bare
    course 0 --version
    grep -qx "Raysteps [0-9.]* ([0-9a-f]*)" out || fail "the number and the commit"
    rm -rf bare/.git
fi

# Without network: one line with the reason, in apt's words.
: > known
{ seq -f 'echo dlstatus:%g:1:wait' 400
  echo 'echo "W: Failed to fetch http://deb/dists/InRelease  Temporary failure resolving deb"'; } > update
echo 'echo "E: Unable to locate package ninja-build"' > install
course 2
says "error: nothing can be installed without the network: Temporary failure resolving deb"
few_lines 4

# A release that does not have a package.
: > update
course 2
says "error: apt-get does not know ninja-build: Raysteps needs Debian 12, Ubuntu 22.04, or a newer one"
few_lines 4

# Another failure: the last three lines that begin with E.
echo ninja-build > known
{ seq -f 'echo line %g'  200; seq -f 'echo "E: reason %g"' 5; } > install
course 2
says "E: reason 3"
says "E: reason 5"
says "error: could not install ninja-build"
says_not "E: reason 2"
few_lines 8

# A package that is gone from the archive: a newer list has it.
cat > install << 'END'
if grep -q update calls; then ninja_comes; else echo "E: Failed to fetch http://deb/ninja.deb  404  Not Found"; fi
END
sed -i '2i ninja_comes() { printf "#!/bin/sh\\n" > fakes/ninja; chmod +x fakes/ninja; }' fakes/apt-get
course 0
grep -q '^-y.* update$' calls || fail "a newer list is fetched"

# mold is not required: where apt does not know it, the rest is installed, and elsewhere it comes too.
echo ninja_comes > install
if [ ! -e /usr/include/mold ] && [ ! -e /usr/local/include/mold ]; then
    course 0
    grep ' install ' calls | grep -q mold && fail "mold is asked of an apt that does not know it"
    echo mold >> known
    course 0
    grep ' install ' calls | grep -q ' ninja-build mold$' || fail "mold is installed, too"
fi

# At a size limit for files there is a sentence; a signal would end what writes the logs without one.
printf '#!/bin/sh\n' > fakes/ninja
chmod +x fakes/ninja
rm -f bare/build/build.ninja
(ulimit -f 0 && PATH=$PWD/fakes:$PWD/tools exec bare/course 2>&1) | cat > out
says "configure.log: "
rm fakes/ninja

# The version, without anything installed or built.
rm -rf bare/build
course 0 --version
grep -qE '^Raysteps [0-9]+\.[0-9]+\.[0-9]+' out || fail "a version"
[ ! -e bare/build ] || fail "nothing is made to tell the version"

# CMake keeps the first compiler: who asks for another one is told.
mkdir -p bare/build
printf '#!/bin/sh\n' > bare/build/course
chmod +x bare/build/course
cat > fakes/cmake << 'END'
#!/bin/sh
printf 'CMAKE_CXX_COMPILER:STRING=%s\nCMAKE_GENERATOR:INTERNAL=Ninja\nCMAKE_HOME_DIRECTORY:INTERNAL=%s\n' \
    "$PWD/fakes/c++" "$PWD/bare" > bare/build/CMakeCache.txt
: > bare/build/build.ninja
END
CXX=clang++ course 0
says "CXX=clang++ has no effect: build/ is of $PWD/fakes/c++; remove it to build with another compiler"
CXX=c++ course 0
says_not "CXX="
exit $failed
