#!/bin/sh
# are_current.sh PROGRAM WRITTEN COMMITTED: fails unless the program writes exactly the *.svg files in
# the folder COMMITTED. Its output stays in the folder WRITTEN for inspection.
rm -rf "$2"
"$1" "$2" && diff -rq --strip-trailing-cr --exclude=source --exclude=engine --exclude=live "$2" "$3" || {
    echo "Look at them in $2; if they are right, build the target update_figures."
    exit 1
}
