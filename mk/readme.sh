#!/bin/sh
# Takes two C programs out of the documents, to be compiled: readme.sh TOP FOLDER writes
# FOLDER/window.c, the README's, and FOLDER/path.c, the last of docs/start/first-host.md.
set -eu

program() { # PAGE NUMBER FILE
    awk -v number="$2" '
        /^```c$/ { inside = ++found == number; next }
        /^```$/ { inside = 0 }
        inside { print }
        END { if (found != number) exit 1 }
    ' "$1" >"$3" || { echo "readme.sh: $1 has not $2 C programs" >&2; exit 1; }
}
program "$1/README.md" 1 "$2/window.c"
program "$1/docs/start/first-host.md" 3 "$2/path.c"
