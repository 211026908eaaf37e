#!/bin/sh
# The statuses that the header names for each function, as a table in C:
# documented.sh HEADER
set -eu

echo '/* Made from libvides.h. */'
echo '#include "libvides.h"'
echo 'static const struct documented { const char *name; unsigned statuses; } documented[] = {'
awk '
    /^\/\*\*/ { statuses = "" }
    /^ \*/ {
        line = $0
        while (match(line, /V_ERR_[A-Z]+/)) {
            statuses = statuses " | 1u << " substr(line, RSTART, RLENGTH)
            line = substr(line, RSTART + RLENGTH)
        }
    }
    /^(int|void|double|const char) .*\(/ && match($0, /v_[a-z_]+\(/) {
        printf "    {\"%s\", 0%s},\n", substr($0, RSTART, RLENGTH - 1), statuses
    }
' "$1"
echo '};'
