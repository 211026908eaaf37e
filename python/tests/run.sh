#!/bin/sh
# Tests a wheel in fresh environments without Rust: run.sh WHEELS FOLDER LIBRARY [large]
#
# Plain: with the interpreter that python3 is, and mypy. Large: with the oldest and the newest
# that there is, each case more often, the examples, notebooks, Blender's and ParaView's Python,
# and pyright. LIBRARY is the libvides.so beside which the package runs.
set -eu

wheel=$(realpath "$1"/vides-*.whl)
mkdir -p "$2"
out=$(realpath "$2")
library=$(realpath "$3")
size=${4:-}
here=$(dirname "$(realpath "$0")")
wanted=$here/../requirements
# Neither Rust nor this folder is to be found.
path=/usr/local/bin:/usr/bin:/bin

# environment NAME PYTHON REQUIREMENTS...: with the wheel, which is always laid anew.
environment() {
    place=$out/$1
    python=$2
    shift 2
    if ! { cat "$@" && "$python" -V; } | cmp -s - "$place/made-of"; then
        rm -rf "$place"
        "$python" -m venv "$place"
        for file; do
            "$place/bin/python" -m pip install --quiet --disable-pip-version-check \
                --only-binary :all: -r "$file"
        done
        { cat "$@" && "$python" -V; } >"$place/made-of"
    fi
    "$place/bin/python" -m pip install --quiet --disable-pip-version-check --no-deps \
        --force-reinstall "$wheel"
}

# The tests lie in a folder of their own: nothing but the wheel can be imported as vides.
rm -rf "$out/lies"
mkdir -p "$out/lies"
cp -r "$here" "$here/../examples" "$here/../pyproject.toml" "$here/../../docs/start/first-script.md" "$out/lies"

tests() {
    place=$out/$1
    shift
    (cd "$out/lies" && env -u DISPLAY -u PYTHONPATH PATH="$path" VIDES_LIBRARY="$library" \
        PYTHONDONTWRITEBYTECODE=1 VIDES_FORMATS="${VIDES_FORMATS:-}" \
        "$place/bin/python" -m pytest -q -p no:cacheprovider "$@" tests)
}

types() {
    (cd "$out/lies" && PATH="$out/$1/bin:$path" && mypy --cache-dir "$out/mypy" -p vides &&
        mypy --cache-dir "$out/mypy" tests examples &&
        python -m mypy.stubtest vides._vides)
}

environment usual python3 "$wanted/test.txt" "$wanted/types.txt"
types usual
[ "$size" = large ] || { tests usual; exit; }

export VIDES_MANY=1
# All that there are from 3.10 on, the oldest and the newest.
versions=
for minor in 10 11 12 13 14 15 16; do
    for known in "python3.$minor" "$HOME"/.pyenv/versions/3."$minor".*/bin/python3; do
        if "$known" -c 'import ensurepip' 2>/dev/null; then
            versions="$versions $known"
            break
        fi
    done
done
# shellcheck disable=SC2086
set -- $versions
oldest=${1:-python3}
while [ $# -gt 1 ]; do shift; done
newest=${1:-python3}
if [ "$oldest" = "$newest" ]; then
    echo "There is one Python here: $("$newest" -V). abi3 is tried with it alone."
else
    environment oldest "$oldest" "$wanted/test.txt"
    echo "The tests with $("$oldest" -V), with many calls"
    tests oldest
fi
environment large "$newest" "$wanted/test.txt" "$wanted/types.txt" "$wanted/large.txt"
echo "The tests with $("$newest" -V), with many calls, examples and notebooks"
tests large -m ''
(cd "$out/lies" && PATH="$out/large/bin:$PATH" pyright -p . &&
    pyright --verifytypes vides --ignoreexternal)
