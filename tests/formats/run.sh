#!/bin/sh
# The formats of others: run.sh FOLDER VIDES [--large]
set -u

formats=$1
vides=$2
shift 2
here=$(dirname "$(realpath "$0")")
export CARGO_TARGET_DIR=$formats/.. PYTHONDONTWRITEBYTECODE=1
python=$formats/small/bin/python
status=0
# The checkers first: what they cannot see, the others would not.
"$python" "$here/check.py" "$vides" --checkers --paths 4 "$@" || status=1
"$python" "$here/check.py" "$vides" "$@" || status=1
"$python" "$here/others.py" "$vides" || status=1
"$python" "$here/pose_lists.py" "$vides" || status=1
"$python" "$here/openusd.py" "$vides" --paths 8 --scenes 10 || status=1
case " $* " in
*' --large '*)
    "$python" "$here/picture.py" "$vides" || status=1
    "$python" "$here/speed.py" "$vides" || status=1
    "$python" "$here/page.py" "$vides" convert || status=1
    ;;
esac
exit $status
