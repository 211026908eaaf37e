#!/bin/bash
# Hosts of other toolkits, with the shared library and with the archive; or programs of
# other people's making: run.sh LIBRARY_FOLDER [others] [NAME...]
set -eu

libraries=$(realpath "$1")
shift
here=$(dirname "$(realpath "$0")")
out=$libraries/../hosts
export LD_LIBRARY_PATH=$libraries PYTHONDONTWRITEBYTECODE=1
export VIDES=$libraries/../release/vides # the command, which samples what a host shows
if [ "${1:-}" = others ]; then
    shift
    "$here/build.sh" "$libraries" "$out" others
    "$here/others.sh" "$libraries" "$out"
    exec python3 "$here/others.py" "$out" "$@"
fi
python3 "$here/lines.py"
"$here/build.sh" "$libraries" "$out"
mkdir -p "$out/archive/library"
ln -sf "$libraries/libvides.a" "$out/archive/library/"
"$here/build.sh" "$out/archive/library" "$out/archive"
status=0
python3 "$here/run.py" "$out" "$@" || status=1
python3 "$here/run.py" "$out/archive" -compiled "$@" || status=1
exit $status
