#!/bin/sh
# The translations are whole, and each rule of translations.py refuses what it is there for:
# translations_test.sh PROJECT_FOLDER. Needs po4a and python3.
for need in po4a msgmerge python3; do
    command -v $need > /dev/null || { echo "not tested: $need is not installed"; exit 77; }
done
here=$(dirname "$0")
failed=0
for test in translations translations_rules; do
    PYTHONDONTWRITEBYTECODE=1 python3 "$here/$test.py" "$1" || failed=1
done
exit $failed
