#!/bin/bash
# How many branches of the engine, the document and the border to C the tests
# take, both ways, by folder: coverage.sh [--missing]
#
# The Rust tests, and the tests in C against an archive with counters. With
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
# A hundred thousand more of the same, the memory of a parser not ours, and a
# limit on the size of files that counts could not be written under.
quick=(--skip a_hundred_thousand --skip a_million --skip parsing_takes --skip dear_texts
    --skip a_failed_run_leaves)

# The window's own tests tell nothing of these folders that others do not.
cargo test --locked --workspace --all-features --no-run --lib --bins --tests --message-format json |
    sed -n 's/.*"executable":"\([^"]*\)".*/\1/p' >"$place/executables"
while read -r test; do
    objects+=(-object "$test")
    case $test in
    */deps/vides-*) "$test" -q "${quick[@]}" ffi:: ;;
    # What they say nothing of, or look at without running it.
    */deps/vides_editor-* | */deps/vides_raster-* | */deps/vides_window-* | */deps/vides_x11-* | */deps/layers-* | */deps/header-* | */deps/manual-*) ;;
    */deps/*) "$test" -q "${quick[@]}" ;;
    esac >"$place/output" 2>&1 || { tail -n 40 "$place/output"; exit 1; }
done <"$place/executables"

# The library as C programs see it, but for the steps of mk/libraries.sh, which
# leave out what the counters need. (The profile `test` would make a test of it.)
as_for_tests=(--config profile.dev.opt-level=2 --config profile.dev.debug=1)
archive=$(cargo rustc --locked --features capi --lib --crate-type staticlib "${as_for_tests[@]}" \
    --message-format json | sed -n 's/.*"\([^"]*\/libvides[^"]*\.a\)".*/\1/p' | tail -n 1)
# The name asks for what writes the counts at a program's end.
export LDFLAGS=-Wl,-u,__llvm_profile_runtime
for source in tests/c/*.c; do
    name=$(basename "$source" .c)
    # Killed processes leave no counts, and the header alone has no branches.
    case $name in silent | saving | faults) continue ;; esac
    ${CC:-cc} -std=gnu99 -O1 -Iinclude -o "$place/$name" "$source" "$archive" \
        $LDFLAGS -lm -lpthread
    objects+=(-object "$place/$name")
    mkdir "$place/folder"
    env -u DISPLAY "$place/$name" "$place/folder" >"$place/output" 2>&1 || {
        echo "coverage: $name failed:"
        tail -n 20 "$place/output"
        exit 1
    }
    rm -rf "$place/folder"
done
# And with windows.
mkdir "$place/library"
ln -s "$archive" "$place/library/libvides.a"
KINDS=archive WAYS=plain tests/calls/run.sh "$place/library" hostile reentry odd_hosts

"$tools/llvm-profdata" merge -sparse "$place"/profiles/*.profraw -o "$place/all.profdata"
"$tools/llvm-cov" export -skip-functions -instr-profile "$place/all.profdata" \
    "${objects[@]}" -sources crates/engine/src/math crates/engine/src/path crates/engine/src/scene crates/engine/src/deform crates/document/src src/ffi >"$place/all.json"
python3 mk/coverage.py "$place/all.json" "$@"
