#!/bin/bash
# How many branches of the engine, the document and the border to C the tests
# take, both ways, by folder: coverage.sh [--missing]
#
# The Rust tests, and the C tests against an archive with counters. With
# --missing also the branches that are never taken, each with its line.
set -eu
cd "$(dirname "$0")/.."
target=$(realpath -m "${CARGO_TARGET_DIR:-target}")
place=$target/coverage
tools=$(echo "$(rustc --print sysroot)"/lib/rustlib/*/bin)
[ -x "$tools/llvm-cov" ] || mk/component.sh llvm-tools
rm -rf "$place"
mkdir -p "$place/profiles"

export RUSTC_WORKSPACE_WRAPPER=$PWD/mk/coverage_rustc.sh
export LLVM_PROFILE_FILE=$place/profiles/%p-%m.profraw
objects=()
# A hundred thousand more of the same, and the memory of a parser not ours.
quick=(--skip a_hundred_thousand --skip a_million --skip parsing_takes --skip dear_texts)

# The window's own tests tell nothing of these folders that others do not.
cargo test --locked --workspace --no-run --lib --bins --tests --message-format json |
    sed -n 's/.*"executable":"\([^"]*\)".*/\1/p' >"$place/executables"
while read -r test; do
    objects+=(-object "$test")
    case $test in
    */deps/vides-*) "$test" -q "${quick[@]}" math:: path:: document:: ffi:: error:: ;;
    */deps/vides_raster-*) ;;
    */deps/*) "$test" -q "${quick[@]}" ;;
    esac >"$place/output" 2>&1 || { tail -n 40 "$place/output"; exit 1; }
done <"$place/executables"

# The library as C programs see it, but for the steps of mk/libraries.sh, which
# leave out what the counters need.
archive=$(cargo rustc --locked --profile test --lib --crate-type staticlib \
    --message-format json | sed -n 's/.*"\([^"]*\/libvides[^"]*\.a\)".*/\1/p' | tail -n 1)
for source in tests/c/*.c; do
    name=$(basename "$source" .c)
    # Killed processes leave no counts, and the header alone has no branches.
    case $name in silent | saving | faults) continue ;; esac
    ${CC:-cc} -std=gnu99 -O1 -Iinclude -o "$place/$name" "$source" "$archive" -lm -lpthread -ldl
    objects+=(-object "$place/$name")
    mkdir "$place/folder"
    env -u DISPLAY "$place/$name" "$place/folder" >"$place/output" 2>&1 || {
        echo "coverage: $name failed:"
        tail -n 20 "$place/output"
    }
    rm -rf "$place/folder"
done

"$tools/llvm-profdata" merge -sparse "$place"/profiles/*.profraw -o "$place/all.profdata"
"$tools/llvm-cov" export -skip-functions -instr-profile "$place/all.profdata" \
    "${objects[@]}" -sources src/engine/math src/engine/path src/document src/ffi >"$place/all.json"
python3 mk/coverage.py "$place/all.json" "$@"
