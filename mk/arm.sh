#!/bin/sh
# The engine on 64-bit ARM, by a cross compiler and an emulator: arm.sh
#
# Its poses there are held against the plain way of computing them, as they are here: each kind of
# vector, curves and their lengths, nodes side by side, and each operation of the vectors by itself.
set -eu
cd "$(dirname "$0")/.."
mk/need.sh aarch64-linux-gnu-gcc=gcc-aarch64-linux-gnu qemu-aarch64=qemu-user \
    /usr/aarch64-linux-gnu/include/stdio.h=libc6-dev-arm64-cross
rustup target add aarch64-unknown-linux-gnu
export CARGO_TARGET_AARCH64_UNKNOWN_LINUX_GNU_LINKER=aarch64-linux-gnu-gcc
export CARGO_TARGET_AARCH64_UNKNOWN_LINUX_GNU_RUNNER='qemu-aarch64 -L /usr/aarch64-linux-gnu'
cargo test --locked --target aarch64-unknown-linux-gnu -p vides-engine --lib -- \
    math:: path::sampling path::arc path::tables scene::side_by_side scene::track
