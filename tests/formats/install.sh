#!/bin/sh
# Fetches the programs that check.py asks, each once: install.sh FOLDER [large]
#
# What is in FOLDER with the same versions stays. Sizes are of the downloads:
#   small: 185 MB, a minute (pycolmap 38, scipy 35, gradio 31, usd-core 29, models of Debian 21,
#          numpy 17, three 5 MB, …)
#   large: 890 MB besides (bpy twice 374, vtk 140, nerfstudio 60 MB, …), and of Debian
#          paraview and torch, 298 MB, two minutes
set -eu

out=$1
here=$(dirname "$(realpath "$0")")
need=$here/../../mk/need.sh
mkdir -p "$out"
out=$(realpath "$out")

# Two checks at once would fetch into one folder.
if [ -z "${VIDES_FORMATS:-}" ] && command -v flock >/dev/null 2>&1; then
    exec flock "$out" env VIDES_FORMATS=alone "$0" "$@"
fi

# fetched NAME FILE...: whether NAME is there, made of these very files.
fetched() {
    name=$1
    shift
    cat "$@" | cmp -s - "$out/$name/made-of"
}

# These versions need nothing else of what their packages name.
pip_install() {
    "$@" -m pip install --quiet --disable-pip-version-check --root-user-action=ignore \
        --no-deps --only-binary :all: $where -r "$here/requirements/$name.txt"
}

environment() {
    fetched "$1" "$here/requirements/$1.txt" && return
    echo "Fetching $1"
    rm -rf "${out:?}/$1"
    python3 -m venv "$out/$1"
    where=
    pip_install "$out/$1/bin/python"
    cp "$here/requirements/$1.txt" "$out/$1/made-of"
}

"$need" python3=python3 python3:ensurepip=python3-venv node=nodejs npm=npm
environment small
if ! fetched node "$here/node/package.json" "$here/node/package-lock.json"; then
    echo 'Fetching node'
    rm -rf "$out/node"
    mkdir "$out/node"
    cp "$here/node/package.json" "$here/node/package-lock.json" "$out/node"
    (cd "$out/node" && npm ci --silent --no-audit --no-fund --ignore-scripts)
    cat "$here/node/package.json" "$here/node/package-lock.json" >"$out/node/made-of"
fi
# node looks for modules from where a program lies.
cp "$here"/importers/*.mjs "$out/node"

# glTF files that others made (others.json), out of their packages.
if ! fetched others "$here/others.json"; then
    echo 'Fetching others'
    rm -rf "$out/others"
    mkdir -p "$out/others/fetched"
    (
        cd "$out/others/fetched"
        npm pack --silent networked-aframe@0.14.3 >/dev/null
        "$out/small/bin/python" -m pip download --quiet --disable-pip-version-check --no-deps gradio==6.31.0
        # As a user of its own apt cannot write here; without lists it finds nothing.
        get() { apt-get download -q -o APT::Sandbox::User=root assimp-testmodels >/dev/null 2>&1; }
        get || { apt-get update -q >/dev/null && get; }
        tar xzf networked-aframe-*.tgz -C ..
        dpkg -x assimp-testmodels_*.deb ..
        "$out/small/bin/python" -m zipfile -e gradio-*.whl .
        mv gradio ..
    )
    rm -rf "$out/others/fetched"
    cp "$here/others.json" "$out/others/made-of"
fi
[ "${2:-}" = large ] || exit 0

lib=/usr/lib/$(gcc -print-multiarch)
"$need" Xvfb=xvfb pvpython=paraview /usr/bin/python3:paraview=python3-paraview \
    /usr/bin/python3:torch=python3-torch /usr/bin/python3:pip=python3-pip \
    "$lib/libGL.so.1=libgl1" "$lib/libEGL.so.1=libegl1" "$lib/libSM.so.6=libsm6" "$lib/libXi.so.6=libxi6" \
    "$lib/libXfixes.so.3=libxfixes3" "$lib/libXrender.so.1=libxrender1" "$lib/libxkbcommon.so.0=libxkbcommon0"
environment bpy-new
environment bpy-old
environment vtk
if ! fetched nerfstudio "$here/requirements/nerfstudio.txt"; then
    echo 'Fetching nerfstudio'
    rm -rf "$out/nerfstudio"
    name=nerfstudio
    where="--target $out/nerfstudio"
    pip_install /usr/bin/python3
    cp "$here/requirements/nerfstudio.txt" "$out/nerfstudio/made-of"
fi
