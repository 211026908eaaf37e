"""Prints the circles of imports between the files of each crate, the largest first.

File A imports file B where A names an item of B: in a `use` whose name it then uses, or in a path.
Names are followed through re-exports to the file that has the item, so that a `mod` or a `pub use`
alone is no import; methods are not seen. Tests are left out. Usage: imports.py [--edges] [--plain]
[--check] [FOLDER]
With --edges also those imports without which the largest circle would be smallest. With --plain
re-exports are imports as others are and not followed. With --check one of more than three files is
an error.
"""

import pathlib
import re
import sys

from count_lines import is_test

NOISE = re.compile(r"""//[^\n]*|/\*.*?\*/|r#".*?"#|"(?:\\.|[^"\\])*"|'(?:\\.|[^'\\\n])[^'\n]{0,8}?'(?!\w)""", re.S)
TESTS = re.compile(r"^( *)#\[cfg\(test\)\]\n(?: *#\[.*\n)* *(?:pub(?:\(\w+\))? )?(?:mod \w+ \{\n.*?^\1\}|[^\n{]*;)", re.S | re.M)
USE = re.compile(r"^ *(?:pub(?:\([^)]*\))? )?use ([^;]+);", re.M)
ITEM = re.compile(
    r"^(?:pub(?:\([^)]*\))? )?(?:(?:const|async|unsafe) )*(?:extern \S* )?"
    r"(?:fn|struct|enum|union|trait|type|const|static|macro_rules!) (\w+)", re.M)
PATH = re.compile(r"(?<![\w:.])\w+(?:::\w+)*")


class File:
    """A file: the items that it has, the names that it uses, and all paths in its text."""

    def __init__(self, path, module):
        text = TESTS.sub("", NOISE.sub("", path.read_text(encoding="utf-8")))
        self.module, self.items = module, set(ITEM.findall(text))
        self.uses, self.globs = {}, []
        for tree in USE.findall(text):
            for leaf in leaves(re.sub(r"\s+", " ", tree)):
                names, _, alias = leaf.strip().removesuffix("::self").partition(" as ")
                names = names.strip().split("::")
                if names[-1] == "*":
                    self.globs.append(names[:-1])
                else:
                    self.uses[alias.strip() or names[-1]] = names
        self.paths = {tuple(found.split("::")) for found in PATH.findall(USE.sub("", text))}


def leaves(tree):
    """The paths of a `use`, its braces written out."""
    while "{" in tree:  # the innermost first
        before, inside = re.search(r"([\w: ]*)\{([^{}]*)\}", tree).groups()
        out = ",".join(before.strip() + leaf.strip() for leaf in inside.split(",") if leaf.strip())
        tree = tree.replace(f"{before}{{{inside}}}", out)
    return tree.split(",")


def plainly(files, file, names):
    """The module to whose file the words of a path lead, whatever that file has."""
    here = file.module
    for name in names:
        if name in ("crate", "self", "super"):
            here = {"crate": (), "self": here, "super": here[:-1]}[name]
        elif here + (name,) in files:
            here += (name,)
    return here


def resolve(files, file, names, seen=()):
    """The module whose file has what the path names from there; None outside the crate."""
    here = file.module
    if (here, tuple(names)) in seen:
        return None
    seen = {*seen, (here, tuple(names))}
    for name in names:
        if name in ("crate", "self", "super"):
            here = {"crate": (), "self": here, "super": here[:-1]}[name]
            continue
        at = files[here]
        if name in at.items:
            return here
        if here + (name,) in files:
            here += (name,)
        elif name in at.uses and at.uses[name] != [name]:
            return resolve(files, at, at.uses[name] + list(names[names.index(name) + 1 :]), seen)
        else:
            found = (resolve(files, at, glob + [name], seen) for glob in at.globs)
            made = here if here != file.module else None  # by a macro, where it is none of ours
            return next((module for module in found if module is not None), made)
    return None


def imports(source, plain=False):
    """For each file of a crate the files that it imports."""
    files = {}
    for path in sorted(source.rglob("*.rs")):
        inside = path.relative_to(source)
        if not is_test(inside):
            module = inside.with_suffix("").parts
            module = module[:-1] if module[-1] in ("mod", "lib", "main") else module
            files[module] = File(path, module)
    if plain:
        for file in files.values():
            paths = {path for path in file.paths if len(path) > 1}
            file.paths = paths.union(map(tuple, [*file.uses.values(), *file.globs]))
    find = plainly if plain else resolve
    found = {file: {find(files, file, path) for path in file.paths} for file in files.values()}
    return {file.module: modules - {None, file.module} for file, modules in found.items()}


def circles(graph):
    """The strongly connected components of more than one file, the largest first."""
    reached = {}
    for start in graph:
        reached[start], left = set(), [start]
        while left:
            new = graph[left.pop()] - reached[start]
            reached[start] |= new
            left.extend(new)
    found = {tuple(sorted(b for b in to if a in reached[b])) for a, to in reached.items() if a in to}
    return sorted(found, key=lambda circle: (-len(circle), circle))


def main():
    most = 0
    root = pathlib.Path(next((a for a in sys.argv[1:] if not a.startswith("--")), "."))
    for source in [root / "src", *sorted(root.glob("crates/*/src"))]:
        graph = imports(source, "--plain" in sys.argv)
        found = circles(graph)
        most = max([most, *map(len, found)])
        print(f"{source.relative_to(root)}: {len(graph)} files, circles: {[len(c) for c in found]}")
        for circle in found:
            print("   ", *("::".join(module) or "crate" for module in circle))
        tried, largest = [], set(found[0] if "--edges" in sys.argv and found else ())
        for a in largest:
            for b in graph[a] & largest:
                left = {c: (graph[c] & largest) - ({b} if c == a else set()) for c in largest}
                size = len(next(iter(circles(left)), ()))
                tried.append((size, "::".join(a), "::".join(b)))
        for size, a, b in sorted(tried)[:20]:
            print(f"    {size:4} without {a or 'crate'} -> {b or 'crate'}")
    if "--check" in sys.argv and most > 3:
        sys.exit(f"imports.py: {most} files of one crate import each other in a circle")


if __name__ == "__main__":
    main()
