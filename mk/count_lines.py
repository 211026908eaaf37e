"""Counts lines of Rust that are neither blank nor comments: code, and tests.

Tests are what stands in `tests/`, in files `tests.rs`, `*_tests.rs` or in a folder `tests`, and in
modules behind `#[cfg(test)]`. Usage: count_lines.py [FOLDER]
"""

import pathlib
import sys

SKIPPED = {"target", "fuzz", ".git", "vidarch"}


def is_test(path):
    """Whether the whole file is a test."""
    return "tests" in path.parts or path.stem == "tests" or path.stem.endswith("_tests")


def count(path):
    """Lines of code and of tests in a file."""
    code = tests = 0
    end = None  # the line that ends a module of tests
    marked = False
    for line in path.read_text(encoding="utf-8").splitlines():
        bare = line.strip()
        if end is None and bare == "#[cfg(test)]":
            marked = True
            continue
        if marked and bare.startswith("mod ") and bare.endswith("{"):
            end = line[: len(line) - len(line.lstrip())] + "}"
        marked = marked and bare.startswith("#[")
        if bare and not bare.startswith("//"):
            if end is None and not is_test(path):
                code += 1
            else:
                tests += 1
        if line == end:
            end = None
    return code, tests


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")
    rooms = {}
    for path in sorted(root.rglob("*.rs")):
        inside = path.relative_to(root)
        if SKIPPED & set(inside.parts):
            continue
        parts = inside.parts
        room = "/".join(parts[:2]) if parts[0] == "crates" else parts[0]
        both = count(path)
        before = rooms.get(room, (0, 0))
        rooms[room] = (before[0] + both[0], before[1] + both[1])
    for room, (code, tests) in rooms.items():
        print(f"{code:8} {tests:8}  {room}")
    print(f"{sum(r[0] for r in rooms.values()):8} {sum(r[1] for r in rooms.values()):8}  all (code, tests)")


if __name__ == "__main__":
    main()
