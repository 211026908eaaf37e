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
lib/cmake/vides/videsConfig.cmake 644
lib/cmake/vides/videsConfigVersion.cmake 644
lib/libvides.a 644
lib/libvides.so -> libvides.so.1
lib/libvides.so.$version 644
lib/libvides.so.1 -> libvides.so.$version
lib/pkgconfig/vides.pc 644
share/applications/vides.desktop 644
share/bash-completion/completions/vides 644
share/fish/vendor_completions.d/vides.fish 644
share/icons/hicolor/scalable/apps/vides.svg 644
share/man/man1/vides.1 644
share/man/man3/libvides.3 644
share/mime/packages/vides.xml 644
share/zsh/site-functions/_vides 644"
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

# ---- What nobody needs in them ------------------------------------------------
no_path_of_this_machine() {
    # Where cargo and what it builds lie, and the source; a checkout in / would be in all of them.
    local places=("${CARGO_HOME:-$HOME/.cargo}/" "$(realpath "${CARGO_TARGET_DIR:-target}")/" "$(realpath .)/")
    ! grep -raF "${places[@]/#/-e}" "$stage/usr/bin" "$stage/usr/lib" "$stage/usr/include" |
        tr -c '[:print:]' '\n' | grep -F "${places[@]/#/-e}" | head -n 5 | grep .
}
no_symbols() { ! readelf -SW "$1" | grep -E '\.(symtab|debug_info)'; }
check "no path of the machine it was built on" no_path_of_this_machine
check "the command is stripped" no_symbols "$stage/usr/bin/vides"

# ---- A C program against the installed files --------------------------------
# Not exported: the build of a library asks pkg-config too, and would begin again.
config() {
    PKG_CONFIG_SYSROOT_DIR=$stage PKG_CONFIG_LIBDIR=$stage/usr/lib/pkgconfig \
        PKG_CONFIG_ALLOW_SYSTEM_CFLAGS=1 PKG_CONFIG_ALLOW_SYSTEM_LIBS=1 pkg-config "$@" vides
}

check "pkg-config: version" same "$version" "$(config --modversion)"
# The programs are those of the README, which opens a window, and of the page for a first host,
# which does without.
"$top/mk/readme.sh" "$top" "$work" || exit 1
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
    # Without a display the one with a window says so, status 1; tests/x opens it.
    case $name in window) status=1 ;; *) status=0 ;; esac
    check "README's $name program runs, shared" same $status \
        "$(env -u DISPLAY LD_LIBRARY_PATH="$stage/usr/lib" "$work/$name-shared" >/dev/null 2>&1; echo $?)"
    said=$(env -u DISPLAY LD_LIBRARY_PATH="$stage/usr/lib" "$work/$name-shared" 2>&1)
    check "README's $name program runs, archive" same $status \
        "$(env -u DISPLAY "$work/$name-archive" >/dev/null 2>&1; echo $?)"
    check "README's $name program: both say the same" \
        same "$said" "$(env -u DISPLAY "$work/$name-archive" 2>&1)"
    check "README's $name program says something" test -n "$said"
done

# The programs of the first pages; those with a window say that there is no display.
awk -v folder="$work" '/^```c$/ { file = folder "/first" ++number ".c"; next } /^```$/ { file = "" }
    file != "" { print >file }' docs/start/first-host.md
for number in 1 2 3; do
    # shellcheck disable=SC2046
    check "first host $number" "$cc" "${warnings[@]}" $(config --cflags) -o "$work/first$number" \
        "$work/first$number.c" $(config --libs)
    said=$(cd "$work" && env -u DISPLAY LD_LIBRARY_PATH="$stage/usr/lib" "./first$number" 2>&1)
    status=$?
    case $number in 3) wanted="poses, the last at 0.6 0.2 0.8$" ;; *) wanted=DISPLAY ;; esac
    check "first host $number says: $said" grep -q "$wanted" <<<"$said"
    check "first host $number: its status" test $status -eq $((number < 3))
done

# ---- A tree that was moved after it was installed -----------------------------
# By CMake and by pkg-config; nothing is left where it was installed first.
moved="$work/moved on"
mv "$own" "$moved"
# A blank in a folder's name comes out of pkg-config behind a backslash.
for library in -lvides -l:libvides.a; do
    flags=$(PKG_CONFIG_LIBDIR="$moved/lib/pkgconfig" pkg-config --define-prefix --cflags --libs vides)
    eval "flags=(${flags/-lvides/$library})"
    check "moved, pkg-config, $library" "$cc" "${warnings[@]}" -o "$work/moved$library" \
        "$work/path.c" "${flags[@]}"
    check "moved, pkg-config, $library: runs" \
        env LD_LIBRARY_PATH="$moved/lib" "$work/moved$library"
done
built=$work/built
# Its own make is nobody's child.
cmake() { env -u MAKE -u MAKEFLAGS -u MAKELEVEL cmake "$@"; }
check "moved, CMake finds it, in versions that fit" \
    cmake -S tests/install/cmake -B "$built" -DCMAKE_PREFIX_PATH="$moved" -DC_HOST="$work/path.c"
check "moved, CMake builds hosts" cmake --build "$built"
for host in c-vides c-static cxx-vides cxx-static; do
    check "moved, CMake: $host runs" "$built/$host"
    case $host in *vides) asks=libvides.so.1 ;; *) asks= ;; esac
    check "moved, CMake: $host asks for ${asks:-no libvides}" same "$asks" \
        "$(readelf -dW "$built/$host" | sed -n 's/.*NEEDED.*\[\(libvides.*\)\]/\1/p')"
done
check "moved, CMake: both libraries say the same" \
    same "$("$built/cxx-vides")" "$("$built/cxx-static")"
check "moved, CMake: the version" test "$("$built/cxx-vides" | sed 's/:.*//')" = "$version"
# As where /lib is a link to /usr/lib: what includes lie beside is the folder behind the link.
mkdir -p "$work/linked" && ln -s "$moved/lib" "$work/linked/lib"
check "moved, CMake finds it through a link" cmake -S tests/install/cmake -B "$built-by-link" \
    -DCMAKE_PREFIX_PATH="$work/linked" -DC_HOST="$work/path.c"
rm "$moved/lib/libvides.a"
check "CMake: a library that is gone is missed" grep -q 'libvides.a is missing' \
    <(cmake -S tests/install/cmake -B "$built-missing" -DCMAKE_PREFIX_PATH="$moved" 2>&1)
mv "$moved" "$own"

# ---- The command and the manual ----------------------------------------------
# Each command that the README and the first pages show, on the path of the README.
mkdir "$work/shell"
sed -n '/^```toml$/,/^```$/p' README.md | sed '/^```/d' >"$work/shell/flight.vid"
sed -n '/^ *```sh$/,/^ *```$/p' README.md docs/start/*.md docs/guides/*.md | grep '^ *vides ' >"$work/shell/commands"
# A cube, away from the way.
cat >"$work/shell/mesh.obj" <<'OBJ'
v -0.2 -0.2 -0.2
v 0.2 -0.2 -0.2
v 0.2 0.2 -0.2
v -0.2 0.2 -0.2
v -0.2 -0.2 0.2
v 0.2 -0.2 0.2
v 0.2 0.2 0.2
v -0.2 0.2 0.2
f 4 3 2 1
f 5 6 7 8
f 1 2 6 5
f 3 4 8 7
f 2 3 7 6
f 4 1 5 8
OBJ
check "the pages show commands" test -s "$work/shell/commands"
while read -r shown; do
    check "shown: ${shown%%#*}" \
        env PATH="$stage/usr/bin:$PATH" sh -c "cd '$work/shell' && $shown"
done <"$work/shell/commands"
check "vides --version" same "vides $version" "$("$stage/usr/bin/vides" --version)"
for page in 1/vides.1 3/libvides.3; do
    check "manual page ${page#*/}" \
        same "" "$(groff -man -Tutf8 -ww -z "$stage/usr/share/man/man$page" 2>&1)"
done

# ---- The reference -------------------------------------------------------------
reference=$work/reference
check "make reference" "$make" reference CARGO_TARGET_DIR="$work"
exported=$(readelf --dyn-syms -W "$stage/usr/lib/libvides.so" |
    sed -n 's/.* FUNC .* \(v_[a-z0-9_]*\)@.*/\1/p' | LC_ALL=C sort)
check "the library has functions" test "$(wc -l <<<"$exported")" -gt 40
check "every function has its manual page" same "$exported" \
    "$(cd "$reference/man3" && ls v_*.3 | sed 's/\.3$//' | LC_ALL=C sort)"
check "every function has its place in HTML" same "" "$(comm -23 <(echo "$exported") \
    <(sed -n 's/.*<section id="\([^"]*\)".*/\1/p' "$reference"/html/*.html | LC_ALL=C sort))"
check "manual pages of the reference" same "" \
    "$(cd "$reference" && grep -L '^\.so ' man3/* | xargs groff -man -Tutf8 -ww -z 2>&1)"
check "names of others lead to a page" same "" "$(cd "$reference" &&
    sed -n 's/^\.so //p' man3/* | sort -u | while read -r page; do [ -e "$page" ] || echo "$page"; done)"
check "HTML of the reference" xmllint --noout "$reference"/html/*.html
check "links of the reference lead somewhere" same "" "$(cd "$reference/html" && comm -23 \
    <(grep -oh 'href="[^"]*"' ./* | sed 's/^href="//; s/"$//' | sort -u) \
    <({ ls; grep -o ' id="[^"]*"' ./* | sed 's/^\.\///; s/: id="/#/; s/"$//'; } | sort -u))"

# ---- The shells complete the command -------------------------------------------
share=$stage/usr/share
check "bash completes" tests/install/completes.bash "$share/bash-completion/completions/vides"
check "zsh completes" timeout 30 tests/install/completes.zsh "$share/zsh/site-functions"
for typed in "vides conv:convert" "vides convert --to gl:glb" "vides convert a.vid --fr:--frames"; do
    check "fish completes ${typed%:*}" grep -q "^${typed##*:}" \
        <(fish --no-config -c "source '$share/fish/vendor_completions.d/vides.fish'
            complete -C '${typed%:*}'")
done

# ---- The desktop -----------------------------------------------------------------
desktop=$own/share/applications/vides.desktop
check "the desktop file is one" desktop-file-validate --warn-kde "$desktop"
check "the type and the icon are XML" xmllint --noout "$own/share/mime/packages/vides.xml" \
    "$own/share/icons/hicolor/scalable/apps/vides.svg"
check "the desktop file has the class of the windows" grep -qF \
    "b\"\\0$(sed -n 's/^StartupWMClass=//p' "$desktop")\\0\"" crates/x11/src/window.rs
# Where a desktop looks, `make install` tells it. A double click is played by what GLib's
# desktops do: the type of a file, its program, the command line of that.
export XDG_DATA_DIRS=$own/share:/usr/share
mkdir "$work/home" "$work/bin"
printf '#!/bin/sh\nprintf "%%s|" "$@" >"%s"\n' "$work/called" >"$work/bin/vides"
chmod +x "$work/bin/vides"
cp examples/pyramid.vid "$work/a flight.vid"
desk() { env HOME="$work/home" PATH="$work/bin:$PATH" "$@"; }
check "into a prefix where a desktop looks" "$make" install PREFIX="$own"
check ".vid files have their type" grep -q 'content-type: application/x-vides$' \
    <(desk gio info -a standard::content-type "$work/a flight.vid")
check "the type's icon is the program's" grep -q 'icon: vides' \
    <(desk gio info -a standard::icon "$work/a flight.vid")
check "the type has its program" grep -q ': vides.desktop$' <(desk gio mime application/x-vides)
check "a double click" desk gio launch "$desktop" "$work/a flight.vid"
for _ in $(seq 50); do [ -s "$work/called" ] && break; sleep 0.1; done
check "a double click opens the editor" same "edit|$work/a flight.vid|" "$(cat "$work/called")"

# ---- The texts -----------------------------------------------------------------
for text in *.md docs/*.md docs/*/*.md benches/*.md; do
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
