#!/bin/sh
# Takes the README's two C programs out of it, to be compiled:
# readme.sh README.md FOLDER writes FOLDER/window.c and FOLDER/path.c.
set -eu

awk -v folder="$2" '
    /^```c$/ { number++; file = folder "/" (number == 1 ? "window" : "path") ".c"; next }
    /^```$/ { file = "" }
    file != "" { print >file }
    END { if (number != 2) { print "readme.sh: not two C programs" >"/dev/stderr"; exit 1 } }
' "$1"
