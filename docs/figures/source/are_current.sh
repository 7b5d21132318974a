#!/bin/sh
# are_current.sh PROGRAM WRITTEN COMMITTED ENGINE: fails unless the program and draw_live.py, with the
# engine, write exactly the *.svg files in the folder COMMITTED. Their output stays in the folder
# WRITTEN for inspection. Status 77 where the live figures cannot be drawn: then only the others count.
rm -rf "$2"
"$1" "$2" || exit
drawn=77
if [ -x /usr/bin/python3 ]; then
    drawn=0
    /usr/bin/python3 -B "${0%/*}/draw_live.py" "$4" "$3/../.." "$2" || drawn=$?
else
    echo "skipped: python3 is missing"
fi
[ "$drawn" = 0 ] || [ "$drawn" = 77 ] || exit "$drawn"
differ=$(diff -rq --strip-trailing-cr --exclude=source --exclude=engine --exclude=live --exclude=printed.txt "$2" "$3")
[ "$drawn" = 0 ] || differ=$(echo "$differ" | grep -v "^Only in $3")
[ -z "$differ" ] || {
    echo "$differ"
    echo "Look at them in $2; if they are right, build the target update_figures."
    exit 1
}
exit "$drawn"
