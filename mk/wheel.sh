#!/bin/sh
# The Python package, a wheel for CPython 3.10 and later: wheel.sh TOOLS OUT
#
# maturin comes into a folder of TOOLS, of the version that python/requirements/build.txt names.
# OUT then holds this one wheel.
set -eu

tools=$1/maturin
out=$2
here=$(dirname "$(realpath "$0")")/..
wanted=$here/python/requirements/build.txt
if ! cmp -s "$wanted" "$tools/made-of"; then
    rm -rf "$tools"
    mkdir -p "$1"
    python3 -m venv "$tools"
    "$tools/bin/pip" install --quiet --disable-pip-version-check --only-binary :all: -r "$wanted"
    cp "$wanted" "$tools/made-of"
fi
mkdir -p "$out"
rm -f "$out"/vides-*.whl
"$tools/bin/maturin" build --quiet --release --locked --manifest-path "$here/python/Cargo.toml" --out "$out"
echo "$out"/vides-*.whl
