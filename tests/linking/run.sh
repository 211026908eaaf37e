#!/bin/bash
# How the two C libraries link: run.sh LIBRARY_FOLDER INCLUDE_FOLDER
#
# Every host is linked as its author would write it, against the archive and
# against the shared library, then run.
set -u

libraries=$(realpath "$1")
include=$(realpath "$2")
here=$(dirname "$(realpath "$0")")
mk=$here/../../mk
cc=${CC:-cc}
cxx=${CXX:-c++}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
passed=0
failed=0

# check NAME COMMAND...: the command must succeed; its output is shown if not.
check() {
    local name=$1
    shift
    if "$@" >"$work/output" 2>&1; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "linking: FAILED: $name"
        tail -n 30 "$work/output" | sed 's/^/    /'
    fi
}

# Runs a host in a folder of its own; it must say "well".
says_well() {
    local folder
    folder=$(mktemp -d "$work/run.XXXX")
    [ "$(VIDES_TRIAL=told LD_LIBRARY_PATH=$shared "$1" "$folder" 2>"$work/errors")" = well ] && return
    cat "$work/errors"
    return 1
}

same() {
    diff <(echo "$1") <(echo "$2")
}

# ---- What the files show ---------------------------------------------------

dynamic_names() { # defined or UND, of a shared library; without versions
    readelf --dyn-syms -W "$1" | awk -v want="$2" '
        $1 ~ /^[0-9]+:$/ && $8 != "" && ($5 == "GLOBAL" || $5 == "WEAK") {
            sub(/@.*/, "", $8)
            if (($7 == "UND") == (want == "UND") && $7 != "ABS") print $8
        }' | sort -u
}

archive_names() {
    readelf -sW "$1" | awk -v want="$2" '
        $1 ~ /^[0-9]+:$/ && $8 != "" && ($5 == "GLOBAL" || $5 == "WEAK") {
            if (($7 == "UND") == (want == "UND")) print $8
        }' | sort -u
}

# What the header declares: a name before an opening parenthesis, not after
# a star in parentheses (a callback).
declared=$("$cc" -E -P -std=c99 "$include/libvides.h" |
    grep -oE '\bv_[a-z0-9_]+ *\(' | tr -d ' (' | sort -u)
library=$libraries/libvides.so
archive=$libraries/libvides.a
check "shared library: exports what the header declares, and nothing else" \
    same "$declared" "$(dynamic_names "$library" defined)"
check "archive: shows what the header declares, and nothing else" \
    same "$declared" "$(archive_names "$archive" defined)"
check "shared library: soname" \
    same libvides.so.1 "$(readelf -dW "$library" | sed -n 's/.*soname: \[\(.*\)\]/\1/p')"
check "shared library: needs the C library only" \
    same "" "$(readelf -dW "$library" | sed -n 's/.*(NEEDED).*\[\(.*\)\]/\1/p' |
        grep -vE '^(libc|libm|ld-linux.*)\.so\.[0-9]+$')"
check "shared library: stays loaded, all names bound at start" \
    same "NODELETE NOW" "$(readelf -dW "$library" | grep FLAGS_1 | grep -oE 'NODELETE|NOW' | sort | xargs)"
check "shared library: no text relocation, no search path" \
    same "" "$(readelf -dW "$library" | grep -E 'TEXTREL|RPATH|RUNPATH')"
check "shared library: no writable code, no executable stack" \
    same "" "$(readelf -lW "$library" | awk '/LOAD|GNU_STACK/ && /RWE/')"
check "shared library: stripped" \
    same "" "$(readelf -SW "$library" | grep -E '\.(symtab|debug_|llvmbc)')"

# Names that the library refers to and that a C program may define.
sed 's/#.*//' "$mk/c89_names.txt" | tr -s ' ' '\n' | sort -u >"$work/reserved"
{
    dynamic_names "$library" UND
    archive_names "$archive" UND
} | sort -u | comm -23 - "$work/reserved" |
    grep -Ev '^(_|pthread_|v_|dl_iterate_phdr$)' >"$work/free"
# The thesis's host, then names of functions that many a host has.
fond="read edit quit ende form
    write open close stat poll select send recv connect bind listen accept
    pause sleep link unlink index pipe dup kill wait alarm fork access
    round trunc hypot cbrt lrint fmin fmax log2 exp2 y0 y1 j0 gamma
    open64 fstat64 lseek64 stat64 mmap64 readdir64 fcntl fcntl64 ioctl writev
    readv getrandom gettid getpid syscall sysconf realpath statx environ_ bcmp
    epoll_wait epoll_ctl timerfd_settime socket sendmsg recvmsg shmget shmat"
{
    cat "$work/free"
    echo $fond | tr ' ' '\n'
} | sort -u | sed 's/.*/NAME(&)/' >"$work/hostile_names.h"
check "names that a host may define are found" test -s "$work/free"

# ---- Hosts -----------------------------------------------------------------

# For each of two libraries (the real one, and the trial one that panics)
# every host is linked with the archive and with the shared object.
c89=(-std=c89 -pedantic -Wall -Wextra -Werror -O1)
compile() { # OUT SOURCE OPTIONS...
    local out=$1 source=$2
    shift 2
    "$cc" "${c89[@]}" "$@" -I"$work" -I"$here" -I"$include" -c -o "$out" "$source"
}

mkdir -p "$work/trial" "$work/other"
(
    cd "$work/trial" &&
        rustc --edition 2024 -O -C panic=unwind --crate-type staticlib --crate-name vides \
            -o trial.a "$here/trial.rs" &&
        "$mk/libraries.sh" trial.a . 1.0.0 &&
        rustc --edition 2024 -O --crate-type staticlib -o "$work/other/libother.a" "$here/other.rs"
) >"$work/output" 2>&1 || {
    cat "$work/output"
    echo "linking: FAILED: the trial library cannot be built"
    exit 1
}

# What the linker warns of in a static program, of a library.
warned_of() { # trial|vides
    if [ "$1" = vides ]; then echo Using getaddrinfo; fi
}

hosts() { # WHICH FOLDER
    local which=$1 kind link
    shared=$2
    mkdir -p "$work/$which-archive"
    ln -s "$2/libvides.a" "$work/$which-archive/"
    check "$which: compiles" compile "$work/use.o" "$here/use_$which.c"
    for kind in archive shared; do
        link=$2
        [ $kind = archive ] && link=$work/$which-archive
        # From here on the link lines are a host's own: `-lvides -lm`.
        export LIBRARY_PATH=$link
        local name="$which, $kind"

        compile "$work/plain.o" "$here/plain.c" || exit 1
        check "$name: plain host links" \
            "$cc" -o "$work/host" "$work/plain.o" "$work/use.o" -lvides -lm
        check "$name: plain host" says_well "$work/host"
        check "$name: the thesis's link line" \
            "$cc" -o "$work/host" "$work/plain.o" "$work/use.o" -lvides -lm -lXm -lXt -lX11
        check "$name: host with Motif" says_well "$work/host"

        check "$name: hostile host compiles" compile "$work/hostile.o" "$here/hostile.c" -fno-builtin
        check "$name: hostile host links" \
            "$cc" -o "$work/host" "$work/hostile.o" "$work/use.o" -lvides -lm
        check "$name: hostile host" says_well "$work/host"
        check "$name: hostile host, all its names visible" \
            "$cc" -rdynamic -o "$work/host" "$work/hostile.o" "$work/use.o" -lvides -lm
        check "$name: hostile host, all its names visible" says_well "$work/host"
        check "$name: hostile library of the host's" \
            "$cc" "${c89[@]}" -shared -fPIC -fno-builtin -DNAMES_ONLY -I"$work" -I"$here" \
            -o "$work/libhostile.so" "$here/hostile.c"
        check "$name: host with a hostile library links" "$cc" -Wl,--no-as-needed -o "$work/host" \
            "$work/plain.o" "$work/use.o" "$work/libhostile.so" -lvides -lm
        check "$name: host with a hostile library" says_well "$work/host"

        check "$name: C++ host compiles" "$cxx" -std=c++98 -pedantic -Wall -Werror -I"$here" \
            -x c++ -c -o "$work/plus.o" "$here/plain.c"
        check "$name: C++ host links" \
            "$cxx" -o "$work/host" "$work/plus.o" "$work/use.o" -lvides -lm
        check "$name: C++ host" says_well "$work/host"

        local order
        for order in "-lvides -lother" "-lother -lvides"; do
            # shellcheck disable=SC2086 (two words)
            check "$name: two Rust libraries link ($order)" "$cc" -o "$work/host" \
                -L"$work/other" -I"$here" "$here/two_rusts.c" "$work/use.o" $order -lm
            check "$name: two Rust libraries ($order)" says_well "$work/host"
        done

        # Its own linker knows no variables of threads, which the archive has.
        check "$name: tcc compiles" \
            tcc -Wall -Werror -I"$here" -I"$include" -c -o "$work/tcc.o" "$here/plain.c"
        check "$name: tcc's host links" \
            "$cc" -o "$work/host" "$work/tcc.o" "$work/use.o" -lvides -lm
        check "$name: tcc's host" says_well "$work/host"
        if [ $kind = shared ]; then
            check "$name: tcc links" tcc -I"$here" -I"$include" -o "$work/host" \
                "$here/plain.c" "$here/use_$which.c" -L"$link" -lvides -lm
            check "$name: tcc's own host" says_well "$work/host"
        fi

        check "$name: without position independence" \
            "$cc" -no-pie -o "$work/host" "$work/plain.o" "$work/use.o" -lvides -lm
        check "$name: without position independence" says_well "$work/host"
        check "$name: unused sections dropped" \
            "$cc" -Wl,--gc-sections -o "$work/host" "$work/plain.o" "$work/use.o" -lvides -lm
        check "$name: unused sections dropped" says_well "$work/host"
        if [ $kind = archive ]; then
            local static
            for static in -static -static-pie; do
                check "$name: $static" \
                    "$cc" $static -o "$work/host" "$work/plain.o" "$work/use.o" -lvides -lm
                # A display's name on the network is the system's to look up.
                check "$name: $static: the one warning" same "$(warned_of "$which")" \
                    "$(grep -o "Using '[^']*'" "$work/output" | sort -u | xargs)"
                check "$name: $static" says_well "$work/host"
            done
        fi
    done
    unset LIBRARY_PATH
}

hosts trial "$work/trial"
hosts vides "$libraries"

shared=$libraries
"$cc" -std=gnu99 -o "$work/kept" "$here/kept.c" || exit 1
check "opened and closed at run time" \
    test "$("$work/kept" "$library" 2>&1)" = well

echo "linking: $passed passed, $failed failed"
[ "$failed" -eq 0 ]
