#!/bin/bash
# What `make install` lays down and `make uninstall` takes away again, and
# whether a C program can be built with it as any other library's user would.
set -u

top=$(dirname "$(realpath "$0")")/../..
cd "$top" || exit 1
make=${MAKE:-make}
cc=${CC:-cc}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
version=$(sed -n 's/^version = "\(.*\)"/\1/p' Cargo.toml | head -n 1)
passed=0
failed=0

check() { # NAME COMMAND...
    local name=$1
    shift
    if "$@" >"$work/output" 2>&1; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "install: FAILED: $name"
        tail -n 30 "$work/output" | sed 's/^/    /'
    fi
}

same() {
    diff <(echo "$1") <(echo "$2")
}

files() { # every file and link below a folder; a link with where it leads
    (cd "$1" && find . -type f -printf '%P %m\n' -o -type l -printf '%P -> %l\n' | LC_ALL=C sort)
}

laid_down="bin/vides 755
include/libvides.h 644
lib/libvides.a 644
lib/libvides.so -> libvides.so.1
lib/libvides.so.$version 644
lib/libvides.so.1 -> libvides.so.$version
lib/pkgconfig/vides.pc 644
share/man/man1/vides.1 644
share/man/man3/libvides.3 644"
laid_down=$(LC_ALL=C sort <<<"$laid_down")

# A folder for a package, and a prefix of one's own with a blank in its name.
stage=$work/stage
own="$work/my own"
check "into DESTDIR" "$make" install DESTDIR="$stage" PREFIX=/usr
check "into DESTDIR: the files" same "$laid_down" "$(files "$stage/usr")"
check "into a prefix with a blank" "$make" install PREFIX="$own"
check "into a prefix with a blank: the files" same "$laid_down" "$(files "$own")"
check "twice is once" "$make" install PREFIX="$own"
check "twice is once: the files" same "$laid_down" "$(files "$own")"

# ---- A C program against the installed files --------------------------------
export PKG_CONFIG_SYSROOT_DIR=$stage
export PKG_CONFIG_LIBDIR=$stage/usr/lib/pkgconfig
export PKG_CONFIG_ALLOW_SYSTEM_CFLAGS=1 PKG_CONFIG_ALLOW_SYSTEM_LIBS=1
config() { pkg-config "$@" vides; }

check "pkg-config: version" same "$version" "$(config --modversion)"
# The programs are the README's own: the first opens a window, the second does
# without.
"$top/mk/readme.sh" README.md "$work" || exit 1
warnings=(-std=c99 -pedantic -Wall -Wextra -Werror)
for name in window path; do
    # shellcheck disable=SC2046 (pkg-config's answer is several words)
    check "README's $name program, shared" \
        "$cc" "${warnings[@]}" $(config --cflags) -o "$work/$name-shared" "$work/$name.c" \
        $(config --libs)
    # shellcheck disable=SC2046
    check "README's $name program, archive" \
        "$cc" "${warnings[@]}" $(config --cflags) -o "$work/$name-archive" "$work/$name.c" \
        $(config --libs | sed 's|-lvides|-l:libvides.a|')
    check "README's $name program: the shared one asks for libvides.so.1" same libvides.so.1 \
        "$(readelf -dW "$work/$name-shared" | sed -n 's/.*NEEDED.*\[\(libvides.*\)\]/\1/p')"
    check "README's $name program: the other one does not" same "" \
        "$(readelf -dW "$work/$name-archive" | sed -n 's/.*NEEDED.*\[\(libvides.*\)\]/\1/p')"
    # Nobody opens windows here; tests/x does.
    check "README's $name program runs, shared" \
        env -u DISPLAY LD_LIBRARY_PATH="$stage/usr/lib" "$work/$name-shared"
    said=$(env -u DISPLAY LD_LIBRARY_PATH="$stage/usr/lib" "$work/$name-shared" 2>&1)
    check "README's $name program runs, archive" env -u DISPLAY "$work/$name-archive"
    check "README's $name program: both say the same" \
        same "$said" "$(env -u DISPLAY "$work/$name-archive" 2>&1)"
    check "README's $name program says something" test -n "$said"
done

# ---- The command and the manual ----------------------------------------------
# Each command that the README shows, on the path that it shows.
mkdir "$work/shell"
sed -n '/^```toml$/,/^```$/p' README.md | sed '/^```/d' >"$work/shell/flight.vid"
sed -n '/^```sh$/,/^```$/p' README.md | grep '^vides ' >"$work/shell/commands"
check "the README shows commands" test -s "$work/shell/commands"
while read -r shown; do
    check "README: ${shown%%#*}" \
        env PATH="$stage/usr/bin:$PATH" sh -c "cd '$work/shell' && $shown"
done <"$work/shell/commands"
check "vides --version" same "vides $version" "$("$stage/usr/bin/vides" --version)"
for page in 1/vides.1 3/libvides.3; do
    check "manual page ${page#*/}" \
        same "" "$(groff -man -Tutf8 -ww -z "$stage/usr/share/man/man$page" 2>&1)"
done

# ---- The texts -----------------------------------------------------------------
for text in *.md docs/*.md benches/*.md; do
    for link in $(grep -oE '\]\([^)#:]+[)#]' "$text" | sed 's/](//; s/.$//'); do
        check "$text: $link is there" test -e "$(dirname "$text")/$link"
    done
done

# ---- Away again ----------------------------------------------------------------
touch "$stage/usr/lib/libother.so" "$own/lib/libvides.so.0"
check "uninstall from DESTDIR" "$make" uninstall DESTDIR="$stage" PREFIX=/usr
check "only what was laid down is gone" same "lib/libother.so 644" "$(files "$stage/usr")"
check "uninstall from the prefix" "$make" uninstall PREFIX="$own"
check "only what was laid down is gone there" same "lib/libvides.so.0 644" "$(files "$own")"

echo "install: $passed passed, $failed failed"
[ "$failed" -eq 0 ]
