"""Adds up branches by folder: coverage.py EXPORT.json [--missing]

Reads what `llvm-cov export` writes. A branch counts twice, once for each way.
Tests within the source do not count, and where the same line was compiled for
several programs or types, a way counts if any of them took it.
"""

import json
import os
import sys
from collections import defaultdict

FOLDERS = ["crates/engine/src/math", "crates/engine/src/path", "crates/engine/src/scene", "crates/engine/src/deform", "crates/document/src", "src/ffi"]


def first_line_of_tests(name):
    """Tests are at the end of a file."""
    with open(name, encoding="utf-8") as source:
        lines = source.read().split("\n")
    for number, line in enumerate(lines, 1):
        if line == "#[cfg(test)]" and lines[number].startswith("mod "):
            return number
    return len(lines) + 1


def ways(export):
    """(file, line, column, end line, end column, way) -> how often it was gone."""
    found = defaultdict(int)
    root = os.getcwd() + os.sep
    for entry in export["data"][0]["files"]:
        name = entry["filename"].removeprefix(root)
        if name.endswith("_tests.rs") or name.endswith("test_support.rs"):
            continue
        end = first_line_of_tests(name)
        for line, column, to_line, to_column, true, false, *_ in entry["branches"]:
            if line < end:
                place = (name, line, column, to_line, to_column)
                found[(*place, True)] += true
                found[(*place, False)] += false
    return found


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        found = ways(json.load(file))
    worst = 100.0
    for folder in FOLDERS:
        counts = [count for way, count in found.items() if way[0].startswith(folder + "/")]
        gone = sum(count > 0 for count in counts)
        share = 100 * gone / len(counts)
        worst = min(worst, share)
        print(f"coverage: {folder}: {gone} of {len(counts)} branches, {share:.1f} %")
    if "--missing" in sys.argv[2:]:
        for (name, line, column, _, _, way), count in sorted(found.items()):
            if count == 0:
                print(f"{name}:{line}:{column}: never {str(way).lower()}")
    return 0 if worst >= 95 else 1


sys.exit(main())
