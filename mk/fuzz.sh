#!/bin/bash
# Fuzzes the readers of files and the planner, one after the other: fuzz.sh SECONDS [TARGET...]
#
# A target is vid, setup, recovery, mesh, planner (what is asked for of it), or formats/NAME for the
# reader of one format; formats stands for those of all.
#
# What was tried and brought the fuzzer further stays in $CARGO_TARGET_DIR/fuzz/
# corpus, so that the next run goes on from there; a file that does harm lies in
# artifacts beside it, and the run ends with an error. Such a file belongs into
# tests/corpus, where `make test` tries it for ever, and the fault mended.
set -eu

seconds=$1
shift
cd "$(dirname "$0")/.."
place=$(realpath -m "${CARGO_TARGET_DIR:-target}")/fuzz
[ $# -gt 0 ] || set -- vid setup recovery mesh planner formats

# The sanitizer and the coverage are switched on by flags that a stable compiler
# keeps to itself, unless it is told that its users build compilers.
RUSTC_BOOTSTRAP=1 cargo fuzz build --target-dir "$place"
built=$place/$(rustc -vV | sed -n 's/^host: //p')/release

# Looking for leaks needs ptrace, which a container may refuse, and then hangs; the
# tests in C look for them.
export ASAN_OPTIONS=detect_leaks=0

targets=
for target; do
    case $target in
    formats) targets="$targets $("$built/formats" 2>&1 | sed 's|^|formats/|')" ;;
    *) targets="$targets $target" ;;
    esac
done

for target in $targets; do
    case $target in
    formats/*) export VIDES_FORMAT=${target#*/} ;;
    esac
    corpus=$place/corpus/$target
    mkdir -p "$corpus" "$place/artifacts/$target" "$(dirname "$place/$target.log")"
    case $target in
    vid | formats/vid) seeds="tests/corpus tests/corpus/vid examples" ;;
    formats/*) seeds=$([ ! -d "tests/corpus/$target" ] || echo "tests/corpus/$target") ;;
    *) seeds=tests/corpus/$target ;;
    esac
    # 32 KiB of text, each read within five seconds. The memory that the check
    # itself allows (fuzz/src/lib.rs) is far less than these limits, which have room
    # for what the sanitizer keeps. A plan of a wild path takes ten seconds, with
    # the sanitizer fifteen times as long, and what it frees meanwhile is kept.
    longest=5 room=1024
    [ "$target" != planner ] || longest=300 room=2048
    "$built/${target%%/*}" "$corpus" $seeds -max_total_time="$seconds" -timeout="$longest" \
        -max_len=32768 -rss_limit_mb="$room" -malloc_limit_mb=256 -print_final_stats=1 \
        -artifact_prefix="$place/artifacts/$target/" >"$place/$target.log" 2>&1 || {
        tail -n 40 "$place/$target.log"
        echo "fuzz: FAILED: $target: see $place/artifacts/$target" >&2
        exit 1
    }
    printf 'fuzz: ok: %s: %s runs, %s, %s files kept, at most %s MB with the sanitizer\n' "$target" \
        "$(sed -n 's/^stat::number_of_executed_units: *//p' "$place/$target.log")" \
        "$(grep -ao 'cov: [0-9]* ft: [0-9]*' "$place/$target.log" | tail -n 1)" \
        "$(find "$corpus" -type f | wc -l)" \
        "$(sed -n 's/^stat::peak_rss_mb: *//p' "$place/$target.log")"
done
