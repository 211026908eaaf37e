#!/bin/sh
# rustc, so that nothing shipped reveals the machine it was built on: rustc.sh RUSTC ...
#
# Paths of crates and of what their build scripts made become /cargo and /out in messages of panics.
# With debugging information they stay, since debuggers look there for the source. (`trim-paths`
# of cargo's profiles would do the same, once it is stable.)
case " $* " in
*debuginfo=[12fl]*) exec "$@" ;;
esac
[ -z "${OUT_DIR:-}" ] || set -- "$@" --remap-path-prefix="$OUT_DIR=/out"
exec "$@" --remap-path-prefix="$PWD=/vides" \
    --remap-path-prefix="${CARGO_HOME:-$HOME/.cargo}=/cargo"
