#!/bin/bash
# Calls as no host should make them, and faults of our own:
# run.sh LIBRARY_FOLDER [hostile|reentry|odd_hosts|names|stack|inject|hand_over]...
#
#     hostile    every function with unfit arguments, in any order
#     reentry    every function from within every callback
#     odd_hosts  what hosts seldom do with windows
#     names      every parameter with what will not do: the message names it
#     stack      how much stack each function takes
#     inject     panics, with a library that is built for them
#     hand_over  memory that runs out while a window hands over, with the same library
#
# Each plainly against the shared library and under AddressSanitizer and UBSan
# against the archive, which is made of the same object; those that need an X
# server have one of their own. One line for each; the exit status is the number
# of failures.
#
#     SEEDS  of hostile (1), CALLS for each of its rounds (600)
#     KINDS  of the library (archive shared), WAYS (plain sanitizers)
#     EACH  not empty: each in each way with each kind, and the whole of reentry
#     AT_ONCE  so many side by side (4), since much of their time is waiting
set -u

libraries=$(realpath "$1")
shift
here=$(dirname "$(realpath "$0")")
root=$here/../..
cc=${CC:-cc}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
touch "$work/failed" # a line for each

"$here/documented.sh" "$root/include/libvides.h" >"$work/documented.h" || exit 99

# build OUTPUT LIBRARY SOURCE FLAGS...
build() {
    local output=$1 library=$2 source=$3
    shift 3
    "$cc" -std=gnu99 -g -O1 -Wall -Wextra -Werror "$@" -I"$work" -I"$root/include" -o "$output" \
        "$here"/{draw,things,every,every_path,every_property,every_tools,every_motion,every_scene,every_contents,hands,served}.c "$here/$source.c" "$library" \
        ${LDFLAGS:-} -lm -lpthread -lX11
}

# A command with a folder of its own, for which the word FOLDER stands.
in_folder() {
    local folder
    folder=$(mktemp -d "$work/folder.XXXX")
    mkdir "$folder/home"
    # What the window saves stays there.
    env -C "$folder" -u RUST_BACKTRACE HOME="$folder/home" XDG_STATE_HOME="$folder/state" XDG_CONFIG_HOME="$folder/config" \
        LD_LIBRARY_PATH="$libraries" \
        ASAN_OPTIONS=detect_leaks=1:detect_stack_use_after_return=1 \
        UBSAN_OPTIONS=halt_on_error=1 timeout "${LIMIT:-900}" "${@//FOLDER/$folder}"
}

# A command under an X server of its own.
with_server() {
    local status server name
    name=$(mktemp "$work/display.XXXX")
    Xvfb -displayfd 3 -screen 0 1280x900x24 -nolisten tcp -noreset -r 3>"$name" 2>/dev/null &
    server=$!
    until [ -s "$name" ]; do
        kill -0 "$server" || return 98
        sleep 0.05
    done
    DISPLAY=:$(cat "$name") in_folder "$@"
    status=$?
    kill "$server" && wait "$server" 2>/dev/null
    return "$status"
}

without_server() {
    (unset DISPLAY && in_folder "$@")
}

# result NAME COMMAND...: the command must succeed; its output is shown if not.
result() {
    local name=$1 output
    output=$(mktemp "$work/output.XXXX")
    shift
    if "$@" >"$output" 2>&1; then
        echo "calls: ok: $name: $(grep -a ' faults' "$output" | tail -n 1)"
    else
        echo "$name" >>"$work/failed"
        echo "calls: FAILED: $name"
        grep -avE '^(vides:|thread|wanted by|note: run with|$)' "$output" | cut -c 1-400 | head -n 80 | sed 's/^/    /'
    fi
}

hostile() { # NAME PROGRAM
    local seed calls=${CALLS:-600}
    for seed in ${SEEDS:-1}; do
        result "$1, seed $seed" with_server "$2" FOLDER "$seed" "$calls"
        result "$1, seed $seed, no display" without_server "$2" FOLDER "$seed" "$((2 * calls))"
    done
}

reentry() { # NAME PROGRAM
    # The longest, and most of it is waiting: some at the same time. Each cell is tried once,
    # with one library or with the other.
    local parts="0 2" part
    [[ $1 = *shared* ]] && parts="1 3"
    [ -n "${EACH:-}" ] && parts="0 1 2 3"
    for part in $parts; do
        result "$1, part $part of 4" with_server "$2" FOLDER "$part" 4 &
    done
    wait
}

inject() { # NAME PROGRAM
    result "$1" with_server "$2" FOLDER
}

odd_hosts() { # NAME PROGRAM
    result "$1" with_server "$2" FOLDER
}

stack() { # NAME PROGRAM
    result "$1" with_server "$2" FOLDER "$root/tests/corpus"
}

hand_over() { # NAME PROGRAM
    result "$1" with_server "$2" FOLDER
}

# From Python, which loads the shared library only.
names() {
    result "names" with_server python3 "$here/names.py" "$libraries/libvides.so" \
        "$root/include/libvides.h" FOLDER
}

one() { # TEST KIND WAY LIBRARY
    local name="$1, $2, $3" program=$work/$1-$2-$3 flags=()
    [ "$3" = sanitizers ] && flags=(-fsanitize=address,undefined -fno-sanitize-recover=undefined)
    if build "$program" "$4" "$1" "${flags[@]}" 2>"$program.output"; then
        "$1" "$name" "$program"
    else
        echo "$name" >>"$work/failed"
        echo "calls: FAILED: $name: does not compile"
        head -n 20 "$program.output" | sed 's/^/    /'
    fi
}

[ $# -gt 0 ] || set -- hostile reentry odd_hosts names stack
for test; do
    if [ "$test" = names ]; then
        names &
        continue
    fi
    for kind in ${KINDS:-archive shared}; do
        library=$libraries/libvides.a
        [ $kind = shared ] && library=$libraries/libvides.so
        for way in ${WAYS:-plain sanitizers}; do
            # What replaces malloc cannot have it replaced again.
            case $test-$kind-$way in
            hand_over-*-sanitizers | stack-*-sanitizers) continue ;;
            inject-archive-plain | inject-shared-sanitizers) ;;
            inject-* | *-archive-plain | *-shared-sanitizers) [ -n "${EACH:-}" ] || continue ;;
            esac
            while [ "$(jobs -rp | wc -l)" -ge "${AT_ONCE:-4}" ]; do wait -n; done
            one "$test" "$kind" "$way" "$library" &
        done
    done
done
wait
failed=$(wc -l <"$work/failed")
exit $((failed > 100 ? 100 : failed))
