"""Counts lines of Rust that are neither blank nor comments: code, and tests.

Tests are what stands in `tests/`, in files `tests.rs`, `*_tests.rs` or in a folder `tests`, in modules
behind `#[cfg(test)]`, and in the files to which such modules lead (`#[path]`, `mod name;`).
Usage: count_lines.py [FOLDER]; --check tests it on a few sample files.
"""

import pathlib
import re
import sys
import tempfile

SKIPPED = {"target", "fuzz", ".git", "vidarch"}
TEST = re.compile(r"#\[cfg\((?:test\b|all\(test\b)")
MODULE = re.compile(r"(?:pub(?:\([^)]*\))? )?mod (\w+)\s*([;{])")
PATH = re.compile(r'#\[path = "([^"]+)"\]')


def is_test(path):
    """Whether the whole file is a test by its name."""
    return "tests" in path.parts or path.stem == "tests" or path.stem.endswith("_tests")


def scanned(path):
    """Lines of code and of tests in a file, and the modules in separate files that it declares:
    name, `#[path]` or none, whether for tests only."""
    code = tests = 0
    modules = []
    end = None  # the line that ends a module of tests
    marked, where = False, None  # what the attributes above say
    for line in path.read_text(encoding="utf-8").splitlines():
        bare = line.strip()
        module = MODULE.match(bare)
        if end is None and TEST.match(bare):
            marked = True
            continue
        if found := PATH.match(bare):
            where = found[1]
        elif module:
            if module[2] == ";":
                modules.append((module[1], where, marked or end is not None))
            elif marked:
                end = line[: len(line) - len(line.lstrip())] + "}"
        if not bare.startswith("#["):
            marked, where = False, None
        if bare and not bare.startswith("//"):
            if end is None:
                code += 1
            else:
                tests += 1
        if line == end:
            end = None
    return code, tests, modules


def file_of(path, name, where):
    """The file of a module that another file declares; none if there is none."""
    if where is not None:
        places = [path.parent / where]
    else:
        # Files in a folder of their own name, but for those that stand for their folder.
        folders = [path.parent / path.stem, path.parent]
        places = [place for folder in folders for place in (folder / f"{name}.rs", folder / name / "mod.rs")]
    return next((place.resolve() for place in places if place.is_file()), None)


def counted(root):
    """Lines of code and of tests of each file below a folder."""
    files = [path for path in sorted(root.rglob("*.rs")) if not SKIPPED & set(path.relative_to(root).parts)]
    known = {path.resolve(): scanned(path) for path in files}
    tests = {path.resolve() for path in files if is_test(path.relative_to(root))}
    # Whom a test declares is a test, too.
    todo = list(known)
    while todo:
        path = todo.pop()
        for name, where, only in known[path][2]:
            inner = file_of(path, name, where)
            if (only or path in tests) and inner in known and inner not in tests:
                tests.add(inner)
                todo.append(inner)
    for path in files:
        code, in_tests, _ = known[path.resolve()]
        yield path.relative_to(root), ((0, code + in_tests) if path.resolve() in tests else (code, in_tests))


def check():
    """Each way to a test, in a separate folder."""
    files = {
        "lib.rs": '#[cfg(test)]\nmod testing;\nmod code;\n#[cfg(test)]\n#[path = "odd/name.rs"]\nmod odd;\nmod code2;\n',
        "testing.rs": "pub mod helper;\nfn a() {}\n",
        "testing/helper.rs": "fn a() {}\n",
        "code.rs": "fn a() {}\n#[cfg(test)]\npub(crate) mod below;\n#[cfg(test)]\nmod tests {\n    fn b() {}\n}\n",
        "code/below/mod.rs": "// A comment.\nmod leaf;\n\nfn c() {}\n",
        "code/below/leaf.rs": "fn d() {}\n",
        "odd/name.rs": "mod beside;\n",
        "odd/beside.rs": "fn e() {}\n",
        "code2/mod.rs": "#[cfg(test)]\nfn only_a_function() {}\nfn f() {}\nmod beside;\n",
        "code2/beside.rs": "fn g() {}\n",
        "code2/some_tests.rs": "fn h() {}\n",
    }
    wanted = {
        "lib.rs": (5, 0), "testing.rs": (0, 2), "testing/helper.rs": (0, 1), "code.rs": (2, 3),
        "code/below/mod.rs": (0, 2), "code/below/leaf.rs": (0, 1), "odd/name.rs": (0, 1), "odd/beside.rs": (0, 1),
        "code2/mod.rs": (3, 0), "code2/beside.rs": (1, 0), "code2/some_tests.rs": (0, 1),
    }  # fmt: skip
    with tempfile.TemporaryDirectory() as folder:
        for name, text in files.items():
            place = pathlib.Path(folder, name)
            place.parent.mkdir(parents=True, exist_ok=True)
            place.write_text(text, encoding="utf-8")
        found = {path.as_posix(): both for path, both in counted(pathlib.Path(folder))}
    if found != wanted:
        sys.exit(f"count_lines.py: {sorted(set(found.items()) ^ set(wanted.items()))}")


def main():
    if sys.argv[1:] == ["--check"]:
        return check()
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")
    rooms = {}
    for inside, both in counted(root):
        parts = inside.parts
        room = "/".join(parts[:2]) if parts[0] == "crates" else parts[0]
        before = rooms.get(room, (0, 0))
        rooms[room] = (before[0] + both[0], before[1] + both[1])
    for room, (code, tests) in rooms.items():
        print(f"{code:8} {tests:8}  {room}")
    print(f"{sum(r[0] for r in rooms.values()):8} {sum(r[1] for r in rooms.values()):8}  all (code, tests)")


if __name__ == "__main__":
    main()
