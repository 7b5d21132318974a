#!/bin/sh
# copy_project.sh PROJECT TARGET: the files in git, or else all files but the build's output.
cd "$1" || exit
if git -c safe.directory="$1" ls-files --error-unmatch course > /dev/null 2>&1; then
    git -c safe.directory="$1" ls-files -z -- . ':!steps/*/student*' | tar --null -T - -cf -
else
    tar -cf - --exclude=./build --exclude=./renders --exclude=./results --exclude=./.git \
        --exclude='./steps/*/student*' .
fi | tar -xf - -C "$2"
