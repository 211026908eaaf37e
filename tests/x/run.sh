#!/bin/bash
# The window from outside: run.sh LIBRARY_FOLDER [NAME...]
#
# C hosts, each linked with the archive and with the shared library, run under X
# servers of their own and are driven by xdotool. NAME chooses tests by a part
# of their name.
set -eu

libraries=$(realpath "$1")
shift
here=$(dirname "$(realpath "$0")")
"$here/build.sh" "$libraries"

# Two locales, one with the comma as the decimal sign: the system's, or made
# for this run.
if ! locale -a 2>/dev/null | grep -qix 'de_DE\.utf-\?8'; then
    LOCPATH=$libraries/../x/locale
    mkdir -p "$LOCPATH"
    [ -e "$LOCPATH/de_DE.UTF-8" ] || localedef -i de_DE -f UTF-8 "$LOCPATH/de_DE.UTF-8"
    export LOCPATH
fi
export LD_LIBRARY_PATH=$libraries PYTHONDONTWRITEBYTECODE=1
exec python3 "$here/run.py" "$libraries/../x" "$@"
