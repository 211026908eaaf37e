#!/bin/sh
# Runs a check, unless it has passed with the same files: once.sh STAMP FILE... -- COMMAND...
#
# FILE may be a folder. Of the machine only the compiler counts: AGAIN=1 runs the check in
# any case.
set -eu

stamp=$1
shift
sums=
while [ "$1" != -- ]; do
    [ -e "$1" ] || { echo "$0: no $1" >&2; exit 2; }
    sums="$sums
$(find -L "$1" -type f ! -path '*/__pycache__/*' -exec sha256sum {} + | LC_ALL=C sort)"
    shift
done
shift
now=$(printf '%s\n' "$sums" "$*" "$(${CC:-cc} --version)" | sha256sum)
if [ -z "${AGAIN:-}" ] && [ "$now" = "$(cat "$stamp" 2>/dev/null)" ]; then
    echo "passed before with these very files (AGAIN=1 runs it again): $*"
    exit 0
fi
mkdir -p "$(dirname "$stamp")"
rm -f "$stamp"
"$@"
echo "$now" >"$stamp"
