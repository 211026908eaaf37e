#!/bin/sh
# Installs a part of the Rust toolchain: component.sh rustfmt|clippy|llvm-tools
set -eu

if command -v rustup >/dev/null 2>&1; then
    exec rustup component add "$1"
fi
# A toolchain from the distribution.
case $1 in
rustfmt) exec "$(dirname "$0")/need.sh" cargo-fmt=rustfmt ;;
clippy) exec "$(dirname "$0")/need.sh" cargo-clippy=rust-clippy ;;
esac
