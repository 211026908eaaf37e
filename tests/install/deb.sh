#!/bin/bash
# The Debian packages in a folder: looked through, installed, used, purged. Needs root or sudo.
set -eu

debs=$(realpath "$1")
top=$(dirname "$(realpath "$0")")/../..
names="libvides1 libvides-dev vides python3-vides"
root=
[ "$(id -u)" -eq 0 ] || root=sudo
work=$(mktemp -d)

# shellcheck disable=SC2086 (names of packages)
present() { dpkg-query -W -f '${db:Status-Status} ${Package}\n' $names 2>/dev/null | grep -v '^not-installed' || true; }
purge() {
    # shellcheck disable=SC2086
    $root env DEBIAN_FRONTEND=noninteractive apt-get purge -y -q $names >/dev/null
}

if [ -n "$(present)" ]; then
    echo "deb: packages of VIDES are installed here, and would be lost: $(present)" >&2
    exit 1
fi
lintian --fail-on error --info "$debs"/*.deb

trap 'purge; rm -rf "$work"' EXIT
$root env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y -q --no-install-recommends "$debs"/*.deb >/dev/null
cd "$work"

# The command.
vides --version
vides sample "$top/examples/pyramid.vid" -o poses.txt
[ "$(wc -l <poses.txt)" -eq 724 ]
desktop=/usr/share/applications/vides.desktop
[ -f $desktop ] && [ -f /usr/share/bash-completion/completions/vides ]

# A C program, by pkg-config and by CMake; shared and static.
"$top/mk/readme.sh" "$top" "$work"
# shellcheck disable=SC2046
cc -std=c99 -Wall -Wextra -Werror $(pkg-config --cflags vides) -o shared path.c $(pkg-config --libs vides)
./shared >of_shared.txt
archive=$(pkg-config --variable=libdir vides)/libvides.a
# shellcheck disable=SC2046
cc -std=c99 $(pkg-config --cflags vides) -o static path.c "$archive" $(pkg-config --libs --static vides | sed 's/-lvides//')
./static >of_static.txt
cmp of_shared.txt of_static.txt
cat >CMakeLists.txt <<'END'
cmake_minimum_required(VERSION 3.16)
project(host C)
find_package(vides 1.0 REQUIRED)
add_executable(host path.c)
target_link_libraries(host vides::vides)
END
cmake -S . -B build >/dev/null
cmake --build build >/dev/null
build/host >of_cmake.txt
cmp of_shared.txt of_cmake.txt
[ -f /usr/share/man/man3/v_haupt.3.gz ]

# Python.
/usr/bin/python3 - <<'END'
import vides
samples = vides.Path().sample()
print("python", vides.__version__, samples.positions.shape)
END

trap 'rm -rf "$work"' EXIT
purge
[ -z "$(present)" ] || { echo "deb: still there: $(present)" >&2; exit 1; }
left=$(find /usr/share /usr/lib /usr/bin /usr/include \( -name 'libvides*' -o -name 'vides*' -o -name '_vides*' -o -name 'v_haupt*' \) 2>/dev/null || true)
[ -z "$left" ] || { echo "deb: left behind: $left" >&2; exit 1; }
echo "deb: lintian has no errors; installed, used, purged"
