#!/bin/bash
# ThreadSanitizer over everything that may be called by several threads at once:
# threads.sh
#
# The library and Rust's standard library are built for it, and tests/c/threads.c
# is linked with both. Building the standard library and the sanitizer are flags
# that a stable compiler keeps to itself, unless it is told that its users build
# compilers.
set -eu
cd "$(dirname "$0")/.."
place=$(realpath -m "${CARGO_TARGET_DIR:-target}")/threads
root=$(rustc --print sysroot)
machine=$(rustc -vV | sed -n 's/^host: //p')
[ -e "$root/lib/rustlib/src/rust/library/Cargo.lock" ] || mk/component.sh rust-src
runtime=$(echo "$root/lib/rustlib/$machine"/lib/librustc-*_rt.tsan.a)
[ -e "$runtime" ] || { echo "threads: this toolchain has no ThreadSanitizer" >&2; exit 1; }

RUSTC_BOOTSTRAP=1 RUSTFLAGS=-Zsanitizer=thread cargo rustc --locked --features capi --lib \
    --crate-type staticlib -Zbuild-std --target "$machine" --target-dir "$place"
# Compiled for it, but linked with rustc's runtime and not with the C compiler's.
cc=${CC:-cc}
"$cc" -std=gnu99 -g -O1 -fsanitize=thread -Iinclude -c -o "$place/threads.o" tests/c/threads.c
"$cc" -o "$place/threads" "$place/threads.o" "$place/$machine/debug/libvides.a" \
    -Wl,--whole-archive "$runtime" -Wl,--no-whole-archive -lm -lpthread -ldl -lrt
TSAN_OPTIONS=halt_on_error=1 "$place/threads"
echo 'threads: ok: no race was seen'
