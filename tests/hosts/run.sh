#!/bin/bash
# Hosts of other toolkits, or programs of other people's making:
# run.sh LIBRARY_FOLDER [others] [NAME...]
set -eu

libraries=$(realpath "$1")
shift
here=$(dirname "$(realpath "$0")")
out=$libraries/../hosts
export LD_LIBRARY_PATH=$libraries PYTHONDONTWRITEBYTECODE=1
"$here/build.sh" "$libraries" "$out" "${1:-}"
if [ "${1:-}" = others ]; then
    shift
    "$here/others.sh" "$libraries" "$out"
    exec python3 "$here/others.py" "$out" "$@"
fi
python3 "$here/lines.py"
exec python3 "$here/run.py" "$out" "$@"
