#!/bin/bash
# The C interface from C, as a host sees it: run.sh LIBRARY_FOLDER [TEST...]
#
# Each test is linked against the archive and against the shared library, and
# run plainly; against the archive under AddressSanitizer and UBSan, too, and
# against the shared library, which is made of the same object, under valgrind:
# each sees what the other does not. EACH, if it is not empty: both with both.
# One line for each; the exit status is the number of failures. AT_ONCE side by
# side (as many as there are processors).
set -u

libraries=$(realpath "$1")
shift
here=$(dirname "$(realpath "$0")")
root=$here/../..
cc=${CC:-cc}
cxx=${CXX:-c++}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
touch "$work/failed" # a line for each

# result NAME COMMAND...: the command must succeed; its output is shown if not.
result() {
    local name=$1 output
    shift
    output=$(mktemp "$work/output.XXXX")
    if "$@" >"$output" 2>&1; then
        # With what a test says of itself: figures, and what it could not try here.
        printf '%s\n' "c: ok: $name" "$(sed -n 's/^note: /c:     /p' "$output")" | sed '/^$/d'
    else
        echo "$name" >>"$work/failed"
        echo "c: FAILED: $name"
        sed 's/^/    /' "$output" | head -n 40
    fi
}

# ---- The header ----------------------------------------------------------------

header() {
    result "header: $*" "$@" -I"$root/include" -Wall -Wextra -Wshadow -Werror -fsyntax-only
}

# Names of parameters that the C library has, too: a host's macro or warning
# may fall over them.
no_parameter_is_a_function_of_libc() {
    local libc names
    libc=$("$cc" -print-file-name=libc.so.6)
    tr '\n' ' ' <"$root/include/libvides.h" |
        sed 's|/\*[^*]*\*\+\([^/*][^*]*\*\+\)*/||g' | grep -o '([^;{}]*);' |
        grep -oE '[A-Za-z_][A-Za-z0-9_]*(\[[0-9]*\])?[,)]' |
        sed 's/[^A-Za-z0-9_].*//' | sort -u >"$work/parameters"
    readelf --dyn-syms -W "$libc" | awk '{ sub(/@.*/, "", $8); print $8 }' | sort -u >"$work/libc"
    names=$(comm -12 "$work/parameters" "$work/libc")
    [ -s "$work/parameters" ] && [ -z "$names" ] || { echo "parameters: $names"; return 1; }
}

only_stddef() {
    diff <(grep '#include' "$root/include/libvides.h") <(echo '#include <stddef.h>')
}

# ---- The tests ---------------------------------------------------------------------

compile() { # OUTPUT LIBRARY SOURCE FLAGS...
    local output=$1 library=$2 source=$3
    shift 3
    "$cc" -std=gnu99 -g -O1 -Wall -Wextra -Werror -Wno-unused-function "$@" -I"$root/include" -o "$output" "$source" \
        "$library" -lm -lpthread
}

run() { # NAME PROGRAM WRAPPER...
    local name=$1 program=$2 folder
    shift 2
    folder=$(mktemp -d "$work/folder.XXXX")
    result "$name" env -u DISPLAY LD_LIBRARY_PATH="$libraries" LOCPATH="$LOCPATH" \
        ASAN_OPTIONS=detect_leaks=1:detect_stack_use_after_return=1 \
        UBSAN_OPTIONS=halt_on_error=1 timeout 600 "$@" "$program" "$folder"
}

check() { # NAME
    local name=$1 source=$here/$1.c kind library program sanitized=yes
    # A test that replaces malloc cannot have it replaced again; one that fails
    # system calls would fail those of the tools, one that kills need not be slow,
    # one that counts threads would count theirs, one that measures time theirs.
    case $name in memory | faults | saving | lookup | removal | progress) sanitized=no ;; esac
    for kind in archive shared; do
        library=$libraries/libvides.a
        [ $kind = shared ] && library=$libraries/libvides.so
        program=$work/$name-$kind
        if ! compile "$program" "$library" "$source" 2>"$program.output"; then
            echo "$name" >>"$work/failed"
            echo "c: FAILED: $name, $kind: does not compile"
            sed 's/^/    /' "$program.output"
            continue
        fi
        run "$name, $kind" "$program"
        [ $sanitized = yes ] || continue
        if [ "$kind${EACH:-}" != shared ]; then
            compile "$program-san" "$library" "$source" -fsanitize=address,undefined \
                -fno-sanitize-recover=undefined &&
                run "$name, $kind, sanitizers" "$program-san"
        fi
        [ "$kind${EACH:-}" != archive ] || continue
        # Fair: its one running thread at a time would else be the same for minutes.
        run "$name, $kind, valgrind" "$program" valgrind -q --fair-sched=yes --error-exitcode=9 \
            --leak-check=full --errors-for-leak-kinds=definite,possible
    done
}

# The comma as the decimal sign: the system's locale, or one made for this run.
LOCPATH=
if ! locale -a 2>/dev/null | grep -qix 'de_DE\.utf-\?8'; then
    LOCPATH=$work/locale
    mkdir -p "$LOCPATH"
    localedef -i de_DE -f UTF-8 "$LOCPATH/de_DE.UTF-8" || exit 99
fi

if [ $# -eq 0 ]; then
    header "$cc" -x c -std=c89 -pedantic "$here/silent.c"
    header "$cc" -x c -std=c99 -pedantic "$here/silent.c"
    header "$cc" -x c -std=c11 -pedantic "$here/silent.c"
    header "$cc" -x c -std=c2x -pedantic "$here/silent.c"
    header "$cxx" -x c++ -std=c++98 -pedantic "$here/silent.c"
    header "$cxx" -x c++ -std=c++20 -pedantic "$here/silent.c"
    result "header: parameters" no_parameter_is_a_function_of_libc
    result "header: includes" only_stddef
    set -- layout errors handles editing shape orientations poses motion readable list memory threads lookup files saving faults process recordings toolbox tools scene contents exchange removal space whole properties progress windows
fi
# Side by side.
for name; do
    while [ "$(jobs -rp | wc -l)" -ge "${AT_ONCE:-$(nproc)}" ]; do wait -n; done
    check "$name" &
done
wait
failed=$(wc -l <"$work/failed")
exit $((failed > 100 ? 100 : failed))
