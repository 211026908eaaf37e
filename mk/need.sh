#!/bin/sh
# Installs what is missing: need.sh WHAT=PACKAGE...
#
# WHAT is a command, a file with its whole path, or a Python module as
# `python3:MODULE` or `/usr/bin/python3:MODULE`; PACKAGE the Debian package that brings
# it. What is there costs nothing. Without root or sudo the packages are named, and
# nothing is done.
set -eu

# What another check is installing just now may be there in part.
if [ -z "${VIDES_NEED:-}" ] && command -v flock >/dev/null 2>&1; then
    flock -s "$0" true
fi
packages=
for pair; do
    what=${pair%%=*}
    case $what in
    *python3:*) "${what%%:*}" -c "import ${what#*:}" 2>/dev/null && continue ;;
    /*) [ -e "$what" ] && continue ;;
    *) command -v "$what" >/dev/null 2>&1 && continue ;;
    esac
    packages="$packages ${pair#*=}"
done
[ -n "$packages" ] || exit 0
# Checks run side by side, and the package manager only once: who comes later
# waits, and looks again.
if [ -z "${VIDES_NEED:-}" ] && command -v flock >/dev/null 2>&1; then
    exec flock "$0" env VIDES_NEED=alone "$0" "$@"
fi

if ! command -v apt-get >/dev/null 2>&1; then
    echo "Please install (names as in Debian):$packages" >&2
    exit 1
fi
if [ "$(id -u)" -eq 0 ]; then
    root=
elif command -v sudo >/dev/null 2>&1 && { [ -t 0 ] || sudo -n true 2>/dev/null; }; then
    root=sudo
else
    echo "Please install, as root: apt-get install$packages" >&2
    exit 1
fi
echo "Installing:$packages"
# Fails on a machine that never fetched the package lists: then fetch them.
install() {
    $root env DEBIAN_FRONTEND=noninteractive \
        apt-get install -y -q --no-install-recommends $packages >/dev/null
}
install 2>/dev/null || { $root apt-get update -q >/dev/null && install; }
