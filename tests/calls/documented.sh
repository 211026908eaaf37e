#!/bin/sh
# The statuses that the header names for each function, as a table in C, and those that
# it names once for all functions, by their parameters:
# documented.sh HEADER
set -eu

echo '/* Made from libvides.h. */'
echo '#include "libvides.h"'
echo 'static const struct documented { const char *name; unsigned statuses; } documented[] = {'
awk '
    /^\/\*\*/ { statuses = "" }
    /^(\/\*\*| \*)/ {
        line = $0
        while (match(line, /V_ERR_[A-Z]+/)) {
            statuses = statuses " | 1u << " substr(line, RSTART, RLENGTH)
            line = substr(line, RSTART + RLENGTH)
        }
    }
    /^(int|void|double|const char) .*\(/ && match($0, /v_[a-z_]+\(/) {
        name = substr($0, RSTART, RLENGTH - 1)
        parameters = ""
    }
    name != "" { parameters = parameters $0 }
    name != "" && /;$/ {
        sub(/^[^(]*/, "", parameters)
        statuses = statuses " | 1u << V_ERR_MEMORY | 1u << V_ERR_LIMIT"
        if (parameters ~ /[*\[]/) statuses = statuses " | 1u << V_ERR_NULL | 1u << V_ERR_ARGUMENT"
        if (parameters ~ /(int|double|size_t|char) |V_(MESH|POSE|NODE|VIEW|ORIENTATION|EDITOR_OPTIONS) /)
            statuses = statuses " | 1u << V_ERR_ARGUMENT | 1u << V_ERR_RANGE"
        if (parameters ~ /capacity|V_(ORIENTATION|PROPERTY|MESH|MOTION|NODE|EDITOR_OPTIONS|VIEW) /)
            statuses = statuses " | 1u << V_ERR_SIZE"
        if (parameters ~ /V_(PATH|SCENE|EDITOR) \*(const \*)?[a-z]/)
            statuses = statuses " | 1u << V_ERR_HANDLE"
        if (parameters ~ /V_SCENE \*[a-z]/) statuses = statuses " | 1u << V_ERR_BUSY"
        if (parameters ~ /V_EDITOR \*[a-z]/) statuses = statuses " | 1u << V_ERR_CLOSED"
        printf "    {\"%s\", 0%s},\n", name, statuses
        name = ""
    }
' "$1"
echo '};'
