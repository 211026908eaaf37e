#!/bin/sh
# Miri over the unsafe code that makes no system calls: miri.sh
#
# The sampler's vectors, once as every x86-64 processor has them and once with
# AVX2, since Miri has only the processor that it is compiled for; and the border's
# handles, pointers and lists. Miri is a part of nightly toolchains only.
set -eu
cd "$(dirname "$0")/.."
command -v rustup >/dev/null || { echo 'miri: rustup is needed' >&2; exit 1; }
# The nightly toolchain that there is, if it has it: none is brought up to date.
cargo +nightly miri --version >/dev/null 2>&1 ||
    rustup toolchain install nightly --profile minimal --component miri,rust-src --no-self-update
place=$(realpath -m "${CARGO_TARGET_DIR:-target}")/miri
# Miri's sines are wrong in their last bits at random by default; equal paths would
# have unequal poses.
export MIRIFLAGS='-Zmiri-disable-isolation -Zmiri-deterministic-floats' PROPTEST_CASES=1

miri() { # PACKAGE FILTER...
    package=$1
    shift
    cargo +nightly miri test --locked --all-features --target-dir "$place" -p "$package" --lib -- "$@"
}

miri vides-engine math::vector path::sampling
RUSTFLAGS='-Ctarget-feature=+avx2,+fma' miri vides-engine math::vector path::sampling
miri vides ffi::
