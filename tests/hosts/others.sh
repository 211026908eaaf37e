#!/bin/bash
# Three programs of other people's making, from Debian's sources, each patched in at
# most ten lines: others.sh LIBRARY_FOLDER FOLDER
#
# The sources come through a configuration of apt's own; the system's lists stay as
# they are. They are fetched once.
set -eu

libraries=$(realpath "$1")
mkdir -p "$2/sources"
out=$(realpath "$2")
here=$(dirname "$(realpath "$0")")
include=$(realpath "$here/../../include")
export LIBRARY_PATH=$libraries C_INCLUDE_PATH=$include
export LD_LIBRARY_PATH=$libraries # NEdit's makefile starts it

apt=$out/apt
fetch() { # PACKAGE: its sources as its authors published them, checked by apt
    mkdir -p "$apt/sources.d" "$apt/lists/partial" "$apt/cache/archives/partial"
    cat >"$apt/apt.conf" <<END
Dir::Etc::sourcelist "$apt/sources.list";
Dir::Etc::sourceparts "$apt/sources.d";
Dir::State::lists "$apt/lists";
Dir::Cache "$apt/cache";
END
    sed -n 's/^deb /deb-src /p' /etc/apt/sources.list >"$apt/sources.list" 2>/dev/null || true
    local list
    for list in /etc/apt/sources.list.d/*.sources; do
        [ -e "$list" ] || continue
        sed 's/^Types:.*/Types: deb-src/' "$list" >"$apt/sources.d/$(basename "$list")"
    done
    export APT_CONFIG=$apt/apt.conf
    ls "$apt"/lists/*Sources* >/dev/null 2>&1 || apt-get update -q >"$apt/log" 2>&1 || true
    if ! (cd "$out/sources" && apt-get source -q --tar-only --download-only "$1" >>"$apt/log" 2>&1)
    then
        cat "$apt/log" >&2
        echo "others.sh: no sources of $1" >&2
        exit 1
    fi
}

for program in nedit xterm l3afpad; do
    patch=$here/$program.patch
    lines=$(grep -c '^[+-][^+-]' "$patch")
    [ "$lines" -le 10 ] || { echo "others.sh: $patch: $lines lines" >&2; exit 1; }
    ls "$out/sources/$program"_*.orig.tar.* >/dev/null 2>&1 || fetch $program
    rm -rf "${out:?}/build-$program"
    mkdir -p "$out/build-$program"
    cd "$out/build-$program"
    tar xf "$(ls "$out/sources/$program"_*.orig.tar.?z | tail -n 1)" --strip-components=1
    patch -s -p1 <"$patch"
    case $program in
    nedit)
        make linux LIBS='-lXm -lXt -lX11 -lvides -lm' ;;
    xterm)
        ./configure --disable-setuid --disable-imake --disable-full-tgetent --disable-freetype
        make EXTRA_LOADFLAGS='-lvides -lm' ;;
    l3afpad)
        # Its own build needs autotools; the files are few.
        touch config.h
        cc -w -I. -Isrc -o l3afpad src/*.c -DPACKAGE='"l3afpad"' -DPACKAGE_NAME='"L3afpad"' \
            -DPACKAGE_VERSION='"0"' -DPACKAGE_STRING='"l3afpad"' -DGETTEXT_PACKAGE='"l3afpad"' \
            -DLOCALEDIR='"/"' -DICONDIR='"/"' $(pkg-config --cflags --libs gtk+-3.0) \
            -lvides -lm ;;
    esac >log 2>&1 || { tail -n 20 log >&2; echo "others.sh: $program does not build" >&2; exit 1; }
    cp "$(find . -name $program -type f -perm -u+x | head -n 1)" "$out/$program"
done
